#include "analysis/flow_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sabo {
namespace {

void keep_each_once(std::vector<std::size_t>& cells) {
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

/// The squares that have a wet corner, by their north-western cells.
std::vector<std::size_t> wet_squares(const Columns& columns, const Grid& grid) {
  std::vector<std::size_t> squares;
  for (const std::size_t cell : columns.touched()) {
    if (!columns.is_wet(cell)) continue;
    const int column = grid.column_at(cell);
    const int row = grid.row_at(cell);
    for (int r = row - 1; r <= row; ++r)
      for (int c = column - 1; c <= column; ++c)
        if (grid.has_cell(c, r) && grid.has_cell(c + 1, r + 1)) squares.push_back(grid.index(c, r));
  }
  keep_each_once(squares);
  return squares;
}

using Corners = std::array<std::size_t, 3>;  // cells

std::vector<Corners> wet_triangles(const Columns& columns, const Raster& elevation) {
  const auto width = static_cast<std::size_t>(elevation.grid.columns);
  std::vector<Corners> triangles;
  for (const std::size_t nw : wet_squares(columns, elevation.grid)) {
    const std::size_t ne = nw + 1, sw = nw + width, se = sw + 1;
    for (const Corners& corners : {Corners{nw, sw, se}, Corners{nw, se, ne}}) {
      const bool has_ground = std::ranges::all_of(
          corners, [&](std::size_t cell) { return std::isfinite(elevation.values[cell]); });
      const bool is_wet =
          std::ranges::any_of(corners, [&](std::size_t cell) { return columns.is_wet(cell); });
      if (has_ground && is_wet) triangles.push_back(corners);
    }
  }
  return triangles;
}

}  // namespace

FlowSurface flow_surface(const Columns& columns, const Raster& elevation) {
  const std::vector<Corners> triangles = wet_triangles(columns, elevation);
  std::vector<std::size_t> cells;
  for (const Corners& corners : triangles)
    cells.insert(cells.end(), corners.begin(), corners.end());
  keep_each_once(cells);

  FlowSurface surface;
  const Grid& grid = elevation.grid;
  for (const std::size_t cell : cells) {
    const double ground = elevation.values[cell], depth = columns.depth(cell);
    surface.mesh.vertices.push_back(
        {grid.x_of(grid.column_at(cell)), grid.y_of(grid.row_at(cell)), ground + depth});
    surface.ground.push_back(ground);
    surface.depth.push_back(depth);
    surface.speed.push_back(depth > 0 ? columns.speed(cell) : 0);
  }
  for (const Corners& corners : triangles) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] =
          static_cast<std::uint32_t>(std::ranges::lower_bound(cells, corners[k]) - cells.begin());
    surface.mesh.triangles.push_back(triangle);
  }
  return surface;
}

}  // namespace sabo
