#include "terrain/dem_difference.hpp"

#include <cmath>

#include "terrain/bilinear.hpp"
#include "terrain/cells_within.hpp"

namespace sabo {
namespace {

/// Calls visit(index, x, y) for each cell of a grid.
template <class Visit>
void for_each_cell(const Grid& grid, Visit&& visit) {
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column)
      visit(grid.index(column, row), grid.x_of(column), grid.y_of(row));
  }
}

}  // namespace

Raster lost_thickness(const DemPair& pair, const Raster& ground, const std::vector<Polygon>& within,
                      double least) {
  Raster thickness(ground.grid, Raster::no_data);
  const auto compare = [&](std::size_t cell, double x, double y) {
    if (std::isnan(ground.values[cell])) return;
    const double lost =
        bilinear(pair.before, x, y, Raster::no_data) - bilinear(pair.after, x, y, Raster::no_data);
    if (lost > least) thickness.values[cell] = lost;  // false for NaN
  };
  if (within.empty()) {
    for_each_cell(ground.grid, compare);
  } else {
    for (const std::size_t cell : cells_within(ground.grid, within)) {
      compare(cell, ground.grid.x_of(ground.grid.column_at(cell)),
              ground.grid.y_of(ground.grid.row_at(cell)));
    }
  }
  return thickness;
}

double lower_to_after(const DemPair& pair, const Raster& thickness, Raster& ground) {
  double volume = 0;
  for_each_cell(ground.grid, [&](std::size_t cell, double x, double y) {
    if (std::isnan(thickness.values[cell])) return;
    const double after = bilinear(pair.after, x, y, Raster::no_data);
    double& z = ground.values[cell];
    if (!(after < z)) return;
    volume += (z - after) * ground.grid.cell_area();
    z = after;
  });
  return volume;
}

}  // namespace sabo
