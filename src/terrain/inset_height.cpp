#include "terrain/inset_height.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/turn.hpp"

// A ball of radius `depth` that rises under (x, y) stops where it first touches the surface: its
// centre is then at the least, over all places q of the surface within reach, of
//   z(q) - sqrt(depth^2 - r(q)^2),   r: horizontal distance of q from (x, y).
// This is convex on a triangle, so the least is at the touching point of the triangle's plane if
// the triangle holds it, else on an edge.

namespace sabo {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// How far the origin is outside [low, high].
double outside(double low, double high) { return std::max({low, -high, 0.0}); }

/// Centre of the ball under the origin that touches an edge; infinite if the edge is out of reach.
double below_edge(const Vec3d& a, const Vec3d& b, double depth) {
  const Vec3d along = b - a;
  const double run = along.x * along.x + along.y * along.y;
  const double foot = -(a.x * along.x + a.y * along.y) / run;  // nearest to the origin in plan
  const double x = a.x + foot * along.x;
  const double y = a.y + foot * along.y;
  const double chord = depth * depth - x * x - y * y;  // half its length, squared
  if (chord <= 0) return never;
  const double touch = foot - along.z * std::sqrt(chord / (run * (run + along.z * along.z)));
  const double place = std::clamp(touch, 0.0, 1.0);
  const double inside = chord - (place - foot) * (place - foot) * run;
  return inside < 0 ? never : a.z + place * along.z - std::sqrt(inside);
}

/// The same for a triangle, counterclockwise in plan.
double below_triangle(const std::array<Vec3d, 3>& corners, double depth) {
  const auto& [a, b, c] = corners;
  const Vec3d up = cross(b - a, c - a);
  const double length = norm(up);
  const Vec3d touch = depth / length * up;
  if (turn(a, b, touch) >= 0 && turn(b, c, touch) >= 0 && turn(c, a, touch) >= 0)
    return (dot(up, a) - depth * length) / up.z;
  return std::min({below_edge(a, b, depth), below_edge(b, c, depth), below_edge(c, a, depth)});
}

}  // namespace

double inset_height(const Surface& surface, double x, double y, double depth) {
  const Raster& elevation = surface.elevation();
  const Grid& grid = elevation.grid;
  const auto vertex_column = [&](double at) {
    return std::clamp((at - grid.west) / grid.dx - 0.5, 0.0, grid.columns - 2.0);
  };
  const auto vertex_row = [&](double at) {
    return std::clamp((grid.north - at) / grid.dy - 0.5, 0.0, grid.rows - 2.0);
  };
  const int first_column = static_cast<int>(vertex_column(x - depth));
  const int last_column = static_cast<int>(vertex_column(x + depth));
  const int first_row = static_cast<int>(vertex_row(y + depth));
  const int last_row = static_cast<int>(vertex_row(y - depth));

  double lowest = surface.height(x, y) - depth;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const auto vertex = [&](int c, int r) {
        return Vec3d{grid.x_of(c) - x, grid.y_of(r) - y, elevation.at(c, r)};
      };
      const Vec3d north_west = vertex(column, row);
      const Vec3d south_east = vertex(column + 1, row + 1);
      const double apart =
          norm(Vec3d{outside(north_west.x, south_east.x), outside(south_east.y, north_west.y), 0});
      if (apart >= depth) continue;
      const double drop = std::sqrt(depth * depth - apart * apart);  // from there, at most
      const Vec3d north_east = vertex(column + 1, row);
      const Vec3d south_west = vertex(column, row + 1);
      for (const auto& corners : {std::array{north_west, south_east, north_east},
                                  std::array{north_west, south_west, south_east}}) {
        const double heights = corners[0].z + corners[1].z + corners[2].z;
        if (!std::isfinite(heights)) continue;
        if (std::min({corners[0].z, corners[1].z, corners[2].z}) - drop >= lowest) continue;
        lowest = std::min(lowest, below_triangle(corners, depth));
      }
    }
  }
  return lowest;
}

}  // namespace sabo
