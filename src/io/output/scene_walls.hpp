#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/output/scene_view.hpp"
#include "terrain/check_dam.hpp"

namespace sabo {

/// A wall of constant thickness along a line, down into the ground; drawn as a solid.
struct SceneWall {
  std::string label = {};  ///< "" for none
  Polyline axis = {};      ///< its z is not used
  double thickness = 0;    ///< m
  std::function<double(double)> top =
      {};  ///< elevation of the top (m) at a station of the axis (m)
};

/// The wall of a check dam with its notch and its name.
SceneWall scene_wall(const CheckDam& dam);

/// One cut through a wall, heights as drawn.
struct WallCut {
  Vec3d left;   ///< upper edge to the left of the axis
  Vec3d right;  ///< upper edge to its right
  double foot = 0;
};

/// The cuts of the pieces of a wall that stand over the mesh; a wall that leaves the mesh between
/// two of its parts has several pieces.
std::vector<std::vector<WallCut>> wall_pieces(const SceneWall& wall, const SceneMesh& mesh);

/// Draws the pieces of a wall, lit from a direction (unit vector towards the light).
void draw_wall(DepthCanvas& canvas, const std::vector<std::vector<WallCut>>& pieces,
               const CanvasView& view, const Vec3d& to_light);

}  // namespace sabo
