#include "terrain/cells_within.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

struct Window {
  int first_column, last_column, first_row, last_row;
};

/// Cells that a polygon's rectangle touches, within the grid.
Window window_of(const Grid& grid, const Polygon& polygon) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double west = infinity, east = -infinity, south = infinity, north = -infinity;
  for (const auto& ring : polygon.rings) {
    for (const Vec3d& v : ring) {
      west = std::min(west, v.x);
      east = std::max(east, v.x);
      south = std::min(south, v.y);
      north = std::max(north, v.y);
    }
  }
  const auto cell = [](double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -1.0, static_cast<double>(count)));
  };
  return {std::max(0, cell((west - grid.west) / grid.dx, grid.columns)),
          std::min(grid.columns - 1, cell((east - grid.west) / grid.dx, grid.columns)),
          std::max(0, cell((grid.north - north) / grid.dy, grid.rows)),
          std::min(grid.rows - 1, cell((grid.north - south) / grid.dy, grid.rows))};
}

}  // namespace

std::vector<std::size_t> cells_within(const Grid& grid, const std::vector<Polygon>& polygons) {
  std::vector<std::size_t> cells;
  for (const Polygon& polygon : polygons) {
    const Window window = window_of(grid, polygon);
    for (int row = window.first_row; row <= window.last_row; ++row) {
      for (int column = window.first_column; column <= window.last_column; ++column) {
        if (contains(polygon, grid.x_of(column), grid.y_of(row)))
          cells.push_back(grid.index(column, row));
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace sabo
