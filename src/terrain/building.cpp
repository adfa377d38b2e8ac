#include "terrain/building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "terrain/cells_within.hpp"
#include "terrain/prism_mesh.hpp"

namespace sabo {
namespace {

constexpr double rectangle_error = 0.05;  // spacings
constexpr double most_samples = 1e4;      // of one edge

/// The box over a rectangle, if the outline is one to within `error` (m).
std::optional<UprightBox> box_over(const Building& building, double error) {
  const Polygon corners = corners_of(building.outline);
  if (corners.rings.size() != 1 || corners.rings[0].size() != 4) return {};
  std::array<Vec3d, 4> plan;
  for (std::size_t k = 0; k < 4; ++k) plan[k] = {corners.rings[0][k].x, corners.rings[0][k].y, 0};
  const auto& [a, b, c, d] = plan;
  const Vec3d along = b - a, across = d - a;
  const double length = norm(along), width = norm(across);
  const double skew = std::abs(dot(along, across)) / std::max(length, width);
  if (norm(a + along + across - c) > error || skew > error) return {};
  const Vec3d middle = 0.5 * (a + c);
  const Vec3d half{length / 2, width / 2, 0};
  UprightBox box{middle - half, middle + half, middle, std::atan2(along.y, along.x)};
  box.low.z = building.bottom;
  box.high.z = building.top;
  return box;
}

}  // namespace

double lowest_ground(const Surface& surface, const Polygon& polygon) {
  const Grid& grid = surface.elevation().grid;
  double lowest = std::numeric_limits<double>::infinity();
  for (const std::size_t cell : cells_within(grid, {polygon})) {
    const double z = surface.elevation().values[cell];
    if (z < lowest) lowest = z;  // false for NaN
  }
  for (const std::vector<Vec3d>& ring : polygon.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec3d edge = ring[(k + 1) % ring.size()] - ring[k];
      const double steps =
          std::clamp(std::ceil(4 * std::hypot(edge.x, edge.y) / std::min(grid.dx, grid.dy)), 1.0,
                     most_samples);
      for (int i = 0; i < steps; ++i) {
        const Vec3d at = ring[k] + i / steps * edge;
        lowest = std::min(lowest, surface.height(at.x, at.y));
      }
    }
  }
  return lowest;
}

Body building_body(const Building& building, double reach, double spacing) {
  if (const auto box = box_over(building, rectangle_error * spacing))
    return {building.name, box_mesh(*box), FlowSide::outside, reach, {*box}};
  TriangleMesh prism = prism_mesh(building.outline, building.bottom, building.top);
  if (prism.triangles.empty())
    throw CaseError("structure " + building.name, "its outline cannot be cut into triangles",
                    "simplify it");
  return {building.name, std::move(prism), FlowSide::outside, reach};
}

}  // namespace sabo
