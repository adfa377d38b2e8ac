#include "terrain/pit_filling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace sabo {
namespace {

template <class Visit>
void for_each_neighbour(const Grid& grid, std::size_t cell, Visit&& visit) {
  const int column = grid.column_at(cell);
  const int row = grid.row_at(cell);
  for (int down = -1; down <= 1; ++down) {
    for (int right = -1; right <= 1; ++right) {
      if (right != 0 || down != 0) visit(column + right, row + down);
    }
  }
}

/// NaN compares as higher than everything.
bool is_lower(double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); }

}  // namespace

bool is_at_border(const Raster& raster, std::size_t cell) {
  bool found = false;
  for_each_neighbour(raster.grid, cell, [&](int column, int row) {
    found = found || !raster.grid.has_cell(column, row) || std::isnan(raster.at(column, row));
  });
  return found;
}

Raster pits_filled(const Raster& elevation) {
  constexpr double rise = 1e-9;  // m per cell of a flat; far above rounding, far below any DEM
  Raster filled = elevation;
  using Flooded = std::pair<double, std::size_t>;  // the cell number makes the order definite
  std::priority_queue<Flooded, std::vector<Flooded>, std::greater<>> open;
  std::vector<std::uint8_t> reached(filled.values.size());
  const auto lowest = std::min_element(filled.values.begin(), filled.values.end(), is_lower);
  for (std::size_t cell = 0; cell < filled.values.size(); ++cell) {
    const bool is_lowest = filled.values.begin() + static_cast<std::ptrdiff_t>(cell) == lowest;
    if (std::isnan(elevation.values[cell])) continue;
    if (!is_lowest && !is_at_border(elevation, cell)) continue;
    reached[cell] = 1;
    open.push({elevation.values[cell], cell});
  }
  while (!open.empty()) {
    const auto [level, cell] = open.top();
    open.pop();
    for_each_neighbour(filled.grid, cell, [&, z = level](int column, int row) {
      if (!filled.grid.has_cell(column, row)) return;
      const std::size_t neighbour = filled.grid.index(column, row);
      if (reached[neighbour] || std::isnan(elevation.values[neighbour])) return;
      reached[neighbour] = 1;
      double& height = filled.values[neighbour];
      height = std::max(height, z + rise);
      open.push({height, neighbour});
    });
  }
  return filled;
}

}  // namespace sabo
