#include "terrain/tilted_plane.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

Raster raster_of(const TiltedPlane& plane, double cell) {
  const double width = plane.east - plane.west, height = plane.north - plane.south;
  const auto pieces = [cell](double length) {
    return std::max(1, static_cast<int>(std::ceil(length / cell - 1e-9)));
  };
  Grid grid;
  grid.columns = pieces(width) + 1;
  grid.rows = pieces(height) + 1;
  grid.dx = width / (grid.columns - 1);
  grid.dy = height / (grid.rows - 1);
  grid.west = plane.west - grid.dx / 2;
  grid.north = plane.north + grid.dy / 2;

  const double along_x = std::sin(plane.azimuth), along_y = std::cos(plane.azimuth);
  // Down the slope from the lowest corner back to a place.
  const auto climb = [&](double x, double y) {
    const double corner_x = along_x > 0 ? plane.east : plane.west;
    const double corner_y = along_y > 0 ? plane.north : plane.south;
    return along_x * (corner_x - x) + along_y * (corner_y - y);
  };
  Raster raster(grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      raster.at(column, row) = plane.lowest + plane.fall * climb(grid.x_of(column), grid.y_of(row));
  return raster;
}

}  // namespace sabo
