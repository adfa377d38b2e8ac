#include "terrain/bilinear.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

double bilinear(const Raster& raster, double x, double y, double missing) {
  const Grid& grid = raster.grid;
  if (!grid.has_cell(grid.column_of(x), grid.row_of(y))) return Raster::no_data;
  const double u = std::clamp((x - grid.west) / grid.dx - 0.5, 0.0, grid.columns - 1.0);
  const double v = std::clamp((grid.north - y) / grid.dy - 0.5, 0.0, grid.rows - 1.0);
  const int column = std::min(static_cast<int>(u), std::max(grid.columns - 2, 0));
  const int row = std::min(static_cast<int>(v), std::max(grid.rows - 2, 0));
  const auto at = [&](int c, int r) {
    const double value = raster.at(std::min(c, grid.columns - 1), std::min(r, grid.rows - 1));
    return std::isnan(value) ? missing : value;
  };
  const double s = u - column;
  const double t = v - row;
  // A corner without weight does not count, whatever it is: 0 x NaN would be NaN.
  const auto part = [&](double weight, int c, int r) { return weight > 0 ? weight * at(c, r) : 0; };
  return part((1 - t) * (1 - s), column, row) + part((1 - t) * s, column + 1, row) +
         part(t * (1 - s), column, row + 1) + part(t * s, column + 1, row + 1);
}

}  // namespace sabo
