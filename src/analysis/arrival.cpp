#include "analysis/arrival.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

std::optional<double> first_arrival(const Raster& arrival, const Polyline& line,
                                    double half_width) {
  // Steps of at most half a cell miss no cell by more than its corner.
  const double cell = std::min(arrival.grid.dx, arrival.grid.dy);
  const double end = length(line);
  const int along = std::max(1, static_cast<int>(std::ceil(2 * end / cell)));
  const int across = static_cast<int>(std::ceil(2 * half_width / cell));
  std::optional<double> first;
  for (int i = 0; i <= along; ++i) {
    const double station = end * i / along;
    const Vec3d place = point_at(line, station);
    const Vec3d forward = direction_at(line, station);
    for (int j = -across; j <= across; ++j) {
      const double offset = across > 0 ? half_width * j / across : 0;
      const int column = arrival.grid.column_of(place.x - offset * forward.y);
      const int row = arrival.grid.row_of(place.y + offset * forward.x);
      if (!arrival.grid.has_cell(column, row)) continue;
      const double time = arrival.at(column, row);
      if (!std::isnan(time) && time < first.value_or(time + 1)) first = time;
    }
  }
  return first;
}

}  // namespace sabo
