#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// Nearest place on a mesh.
struct MeshPoint {
  Vec3d point;
  double distance = 0;  ///< m, not negative
  std::uint32_t triangle = 0;
};

/// Answers how far a mesh is and what lies inside of it, by a tree of boxes around its triangles.
class MeshDistance {
 public:
  /// The mesh is closed and faces outwards (orient_outwards()).
  explicit MeshDistance(TriangleMesh mesh);

  /// Nearest point within `reach` (m); none if there is no such point.
  std::optional<MeshPoint> nearest(const Vec3d& point, double reach) const;

  /// The same among the triangles whose own nearest point is accepted.
  std::optional<MeshPoint> nearest(const Vec3d& point, double reach,
                                   const std::function<bool(const MeshPoint&)>& accepts) const;

  /// Whether the mesh goes around a point: its winding number is above 1/2. Neither a ray that
  /// touches an edge nor parts that overlap deceive it. Far triangles count together, as the dipole
  /// of their area (Barill et al. 2018).
  bool is_inside(const Vec3d& point) const;

  const TriangleMesh& mesh() const { return mesh_; }
  const Bounds& bounds() const { return nodes_.front().bounds; }

 private:
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0;  // of its triangles
    std::uint32_t last = 0;
    std::uint32_t second = 0;  // the second child, the first one comes next; 0: a leaf
    Vec3d area;                // sum of the area vectors
    Vec3d centre;              // of the area
    double radius = 0;         // of a ball around the centre that holds the triangles, m
  };

  void build(std::uint32_t first, std::uint32_t last);
  double winding_of(std::uint32_t number, const Vec3d& point) const;
  template <class Accepts>
  void search(const Vec3d& point, MeshPoint& best, Accepts&& accepts) const;

  TriangleMesh mesh_;  // triangles in the order of the tree
  std::vector<Node> nodes_;
};

}  // namespace sabo
