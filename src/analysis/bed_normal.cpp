#include "analysis/bed_normal.hpp"

#include <cmath>

namespace sabo {
namespace {

/// Rise of the ground per metre between the cells a step to each side; 0 without a neighbour.
double rise(const Raster& ground, int column, int row, int columns, int rows) {
  const Grid& grid = ground.grid;
  const auto value = [&](int sign) {
    const int c = column + sign * columns, r = row + sign * rows;
    return grid.has_cell(c, r) ? ground.values[grid.index(c, r)] : Raster::no_data;
  };
  const double here = ground.values[grid.index(column, row)];
  double before = value(-1), after = value(1);
  double steps = 2;
  if (std::isnan(before)) before = here, --steps;
  if (std::isnan(after)) after = here, --steps;
  const double width = columns != 0 ? grid.dx : grid.dy;
  return steps > 0 ? (after - before) / (steps * width) : 0;
}

}  // namespace

Raster bed_normal_thickness(const Raster& depth, const Raster& ground) {
  Raster thickness(depth.grid);
  const Grid& grid = depth.grid;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t cell = grid.index(column, row);
      const double east = rise(ground, column, row, 1, 0), south = rise(ground, column, row, 0, 1);
      thickness.values[cell] = std::isnan(ground.values[cell])
                                   ? Raster::no_data
                                   : depth.values[cell] / std::hypot(1, east, south);
    }
  return thickness;
}

}  // namespace sabo
