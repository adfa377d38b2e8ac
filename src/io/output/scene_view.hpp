#pragma once

#include <optional>
#include <vector>

#include "io/output/camera.hpp"
#include "io/output/depth_canvas.hpp"
#include "io/output/scene_mesh.hpp"

namespace sabo {

/// Corners that a picture of the scene has to hold: those with flow; without flow, all. As drawn.
std::vector<Vec3d> points_to_show(const SceneMesh& mesh);

/// From the scene to the samples of a canvas.
struct CanvasView {
  Camera camera;
  double scale = 1;  ///< samples per px of the camera
  double top = 0;    ///< px of the camera's picture that are cut off at its top

  /// A place on the canvas; nearness is not positive for points behind the camera.
  CanvasCorner corner(const Vec3d& point) const;
};

/// Draws ground and flow, as a slab that is cut along the edges of the mesh.
void draw_mesh(DepthCanvas& canvas, const SceneMesh& mesh, const CanvasView& view);

/// What is known beforehand of a direction of view, degrees as in LookDirection.
struct LookWish {
  std::optional<double> azimuth = {};
  std::optional<double> down = {};
  std::optional<double> up_valley = {};  ///< azimuth; else from the lowest flow (or ground) to the
                                         ///< highest
};

/// A direction from which the flow is seen well, as far as it is not given: of some directions up
/// the valley that one which shows the most of the flow, 35 degrees down or steeper where the
/// valley's sides would hide more than a tenth of it.
LookDirection choose_direction(const SceneMesh& mesh, const LookWish& wish);

}  // namespace sabo
