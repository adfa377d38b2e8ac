#include "io/output/scene_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

// A flat face between four corners, in the order around it.
void draw_face(DepthCanvas& canvas, const std::array<Vec3d, 4>& face, const CanvasView& view,
               double shade) {
  std::array<CanvasCorner, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = view.corner(face[k]);
    corners[k].shade = static_cast<float>(shade);
    if (!(corners[k].nearness > 0)) return;  // behind the camera
  }
  canvas.draw_solid(corners[0], corners[1], corners[2], Shown::wall);
  canvas.draw_solid(corners[0], corners[2], corners[3], Shown::wall);
}

Vec3d at_foot(Vec3d edge, double foot) {
  edge.z = foot;
  return edge;
}

}  // namespace

SceneWall scene_wall(const CheckDam& dam) {
  return {dam.name, dam.axis, dam.thickness, [dam](double station) { return dam.top(station); }};
}

std::vector<std::vector<WallCut>> wall_pieces(const SceneWall& wall, const SceneMesh& mesh) {
  const double whole = length(wall.axis);
  if (!(whole > 0) || !wall.top) return {};
  // Fine enough for the sides of a notch, and bounded for a long dike.
  const double parts =
      std::clamp(std::ceil(whole / std::max(wall.thickness / 4, 1e-3)), 8.0, 800.0);
  std::vector<std::vector<WallCut>> pieces(1);
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= static_cast<int>(parts); ++i) {
    const double station = whole * i / parts;
    const Vec3d middle = point_at(wall.axis, station);
    const double ground = mesh.height(middle.x, middle.y);
    const double top = wall.top(station);
    if (!std::isfinite(ground) || !std::isfinite(top)) {
      if (!pieces.back().empty()) pieces.emplace_back();
      continue;
    }
    lowest = std::min(lowest, ground);
    const Vec3d along = direction_at(wall.axis, station);
    const Vec3d aside = wall.thickness / 2 * Vec3d{-along.y, along.x, 0};
    const Vec3d edge{middle.x, middle.y, mesh.drawn(top)};
    pieces.back().push_back({edge + aside, edge - aside});
  }
  // Some way into the ground, whose mesh may be coarser than the wall.
  const double foot = mesh.drawn(lowest - 2 * mesh.spacing());
  for (std::vector<WallCut>& piece : pieces) {
    for (WallCut& cut : piece) cut.foot = std::min(foot, cut.left.z);
  }
  return pieces;
}

void draw_wall(DepthCanvas& canvas, const std::vector<std::vector<WallCut>>& pieces,
               const CanvasView& view, const Vec3d& to_light) {
  // Sides a little darker than the top, so that the edge between them shows in any light.
  const auto shade = [&to_light](const Vec3d& normal) {
    return (normal.z > 0 ? 1 : 0.75) * (0.5 + 0.5 * dot(normal, to_light));
  };
  const auto end = [&](const WallCut& cut, const Vec3d& outwards) {
    draw_face(canvas,
              {cut.left, cut.right, at_foot(cut.right, cut.foot), at_foot(cut.left, cut.foot)},
              view, shade(outwards));
  };
  for (const std::vector<WallCut>& piece : pieces) {
    for (std::size_t k = 1; k < piece.size(); ++k) {
      const WallCut &a = piece[k - 1], &b = piece[k];
      const Vec3d across = a.left - a.right;
      const double thickness = std::hypot(across.x, across.y);
      const Vec3d left = thickness > 0 ? (1 / thickness) * Vec3d{across.x, across.y, 0} : Vec3d{};
      const Vec3d along{left.y, -left.x, 0};
      draw_face(canvas, {a.left, a.right, b.right, b.left}, view, shade({0, 0, 1}));
      draw_face(canvas, {a.left, b.left, at_foot(b.left, b.foot), at_foot(a.left, a.foot)}, view,
                shade(left));
      draw_face(canvas, {a.right, b.right, at_foot(b.right, b.foot), at_foot(a.right, a.foot)},
                view, shade(-left));
      if (k == 1) end(a, -along);
      if (k + 1 == piece.size()) end(b, along);
    }
  }
}

}  // namespace sabo
