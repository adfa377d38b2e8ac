#include "terrain/steepest_descent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "terrain/pit_filling.hpp"

namespace sabo {
namespace {

const char* const place = "path";
const char* const remedy = "give [path] line";

/// The neighbour in the direction of the steepest fall, or the cell itself.
std::size_t next_cell(const Raster& filled, std::size_t cell) {
  const Grid& grid = filled.grid;
  const int column = grid.column_at(cell);
  const int row = grid.row_at(cell);
  std::size_t best = cell;
  double steepest = 0;
  for (int down = -1; down <= 1; ++down) {
    for (int right = -1; right <= 1; ++right) {
      if (!grid.has_cell(column + right, row + down)) continue;
      const std::size_t neighbour = grid.index(column + right, row + down);
      const double fall = filled.values[cell] - filled.values[neighbour];
      if (!(fall > 0)) continue;
      const double slope = fall / std::hypot(right * grid.dx, down * grid.dy);
      if (slope > steepest) {
        steepest = slope;
        best = neighbour;
      }
    }
  }
  return best;
}

/// Mean over `reach` vertices on either side, fewer near the ends, which stay where they are.
std::vector<Vec3d> smoothed(const std::vector<Vec3d>& path, std::size_t reach) {
  std::vector<Vec3d> result(path.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    const std::size_t side = std::min({reach, k, path.size() - 1 - k});
    Vec3d sum;
    for (std::size_t n = k - side; n <= k + side; ++n) sum += path[n];
    result[k] = (1.0 / static_cast<double>(2 * side + 1)) * sum;
  }
  return result;
}

/// Points of the line at equal distances of about `step`.
Polyline resampled(const Polyline& line, double step) {
  const double total = length(line);
  const int pieces = std::max(1, static_cast<int>(std::lround(total / step)));
  Polyline result{{}, line.has_z};
  for (int k = 0; k <= pieces; ++k) {
    result.vertices.push_back(point_at(line, total * k / pieces));
  }
  return result;
}

}  // namespace

Polyline steepest_descent(const Raster& elevation, double x, double y) {
  const Grid& grid = elevation.grid;
  const int column = grid.column_of(x);
  const int row = grid.row_of(y);
  if (!grid.has_cell(column, row) || std::isnan(elevation.at(column, row))) {
    throw CaseError(place, "the path of steepest descent starts outside the DEM", remedy);
  }
  const Raster filled = pits_filled(elevation);
  std::vector<Vec3d> path{{x, y, elevation.at(column, row)}};
  std::size_t cell = grid.index(column, row);
  for (std::size_t next = next_cell(filled, cell); next != cell; next = next_cell(filled, cell)) {
    cell = next;
    path.push_back(
        {grid.x_of(grid.column_at(cell)), grid.y_of(grid.row_at(cell)), elevation.values[cell]});
    if (is_at_border(elevation, cell)) break;
  }
  // The last of the lowest: a flat floor is crossed to its border.
  const auto lowest =
      std::min_element(path.rbegin(), path.rend(), [](const Vec3d& a, const Vec3d& b) {
        return a.z < b.z;
      }).base();
  if (lowest - path.begin() > 1) path.erase(lowest, path.end());
  if (path.size() < 2) {
    throw CaseError(place, "the ground at the release falls in no direction", remedy);
  }
  constexpr std::size_t reach = 4;
  return resampled({smoothed(smoothed(path, reach), reach), true}, 3 * std::max(grid.dx, grid.dy));
}

}  // namespace sabo
