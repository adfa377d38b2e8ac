#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/box_mesh.hpp"
#include "geometry/inside_map.hpp"
#include "geometry/mesh_distance.hpp"

namespace sabo {

/// On which side of a mesh the flow is.
enum class FlowSide { outside, inside };

/// A solid at rest in the flow. Where the flow is outside of a mesh, all of its inside is
/// solid; where the flow is inside, a shell of some thickness around it. Copies share their mesh.
class Body {
 public:
  /// `mesh` is closed and faces outwards. `boxes` fill its inside exactly, if there are any. To the
  /// depth `reach` (m) a solid is felt by the flow; it is the thickness of the shell around a mesh
  /// with the flow in it.
  Body(std::string name, TriangleMesh mesh, FlowSide flow, double reach,
       std::vector<UprightBox> boxes = {});

  const std::string& name() const { return name_; }
  const TriangleMesh& mesh() const { return distance_->mesh(); }
  const MeshDistance& distance() const { return *distance_; }
  const std::vector<UprightBox>& boxes() const { return boxes_; }
  FlowSide flow() const { return flow_; }
  double reach() const { return reach_; }
  /// Of all that may be solid.
  Bounds bounds() const;

  /// Whether a point is in the solid.
  bool contains(const Vec3d& point) const;

  /// Whether a point is on that side of the mesh on which the solid is, however deep.
  bool is_behind(const Vec3d& point) const;

  /// Nearest place outside, a `gap` (m) from the surface, that is accepted, for a point in the
  /// solid; none if there is no such place.
  std::optional<Vec3d> way_out(const Vec3d& point, double gap,
                               const std::function<bool(const Vec3d&)>& accepts) const;

 private:
  std::string name_;
  std::shared_ptr<const MeshDistance> distance_;
  std::shared_ptr<const InsideMap> inside_;
  FlowSide flow_;
  double reach_;
  std::vector<UprightBox> boxes_;
};

}  // namespace sabo
