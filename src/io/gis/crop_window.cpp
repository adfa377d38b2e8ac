#include "io/gis/crop_window.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"

namespace sabo {

CellWindow cells_touching(const Grid& grid, const std::array<double, 4>& bounds) {
  const auto& [west, south, east, north] = bounds;
  constexpr double slack = 1e-6;  // cells
  const auto clipped = [](double cell, int count) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count)));
  };
  CellWindow window;
  window.column = clipped(std::floor((west - grid.west) / grid.dx + slack), grid.columns);
  window.row = clipped(std::floor((grid.north - north) / grid.dy + slack), grid.rows);
  window.columns =
      clipped(std::ceil((east - grid.west) / grid.dx - slack), grid.columns) - window.column;
  window.rows = clipped(std::ceil((grid.north - south) / grid.dy - slack), grid.rows) - window.row;
  return window;
}

CellWindow crop_window(const Grid& grid, const std::array<double, 4>& crop,
                       const std::string& name) {
  const auto& [west, south, east, north] = crop;
  if (!(west < east && south < north)) {
    throw CaseError("terrain.crop", "the window is empty",
                    "give [west, south, east, north] with west < east and south < north");
  }
  const CellWindow window = cells_touching(grid, crop);
  if (window.columns < 2 || window.rows < 2) {
    throw CaseError("terrain.crop", "the window holds less than 2 x 2 cells of " + name,
                    fmt::format("choose it within [{:.9g}, {:.9g}, {:.9g}, {:.9g}]", grid.west,
                                grid.south(), grid.east(), grid.north));
  }
  return window;
}

Grid part_of(Grid grid, const CellWindow& window) {
  grid.columns = window.columns;
  grid.rows = window.rows;
  grid.west += window.column * grid.dx;
  grid.north -= window.row * grid.dy;
  return grid;
}

}  // namespace sabo
