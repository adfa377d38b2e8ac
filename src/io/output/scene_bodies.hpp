#pragma once

#include <string>

#include "geometry/triangle_mesh.hpp"

#include "io/output/scene_overlay.hpp"
#include "io/output/scene_view.hpp"

namespace sabo {

/// A body in a scene, of which the faces towards the camera show: through the near walls of a
/// tank, whose faces look inwards, one sees into it.
struct SceneBody {
  std::string label = {};  ///< "" for none
  TriangleMesh mesh = {};  ///< faces look outwards from the solid
  bool is_solid = true;
};

/// What of a body is over a rectangle of the ground, cut along its edges; a solid is closed there.
SceneBody within(const MapView& view, const SceneBody& body);

/// Draws a body, lit from a direction (unit vector towards the light).
void draw_body(DepthCanvas& canvas, const SceneBody& body, const SceneMesh& mesh,
               const CanvasView& view, const Vec3d& to_light);

/// The label of a body above one of its vertices.
void label_body(const ScenePage& page, const SceneBody& body, SceneLabels& labels);

}  // namespace sabo
