#include "analysis/run_out.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/station_index.hpp"

namespace sabo {

std::optional<FootprintPlace> place_of(const Grid& grid, const std::vector<std::size_t>& cells,
                                       const Polyline& path) {
  if (cells.empty()) return std::nullopt;
  FootprintPlace place;
  std::vector<Vec3d> centres;
  for (const std::size_t cell : cells) {
    const int column = grid.column_at(cell);
    const int row = grid.row_at(cell);
    centres.push_back({grid.x_of(column), grid.y_of(row), 0});
    place.centroid_x += centres.back().x;
    place.centroid_y += centres.back().y;
  }
  const auto count = static_cast<double>(cells.size());
  place.centroid_x /= count;
  place.centroid_y /= count;
  // The foremost share of one cell is the farthest cell.
  const std::vector<double> masses(centres.size(), 1.0);
  place.station = *StationIndex(path).foremost(centres, masses, 1 / count);
  return place;
}

std::optional<double> arrival_at(const Raster& arrival, double x, double y) {
  const Grid& grid = arrival.grid;
  const int column = grid.column_of(x), row = grid.row_of(y);
  if (!grid.has_cell(column, row)) return std::nullopt;
  if (!std::isnan(arrival.at(column, row))) return arrival.at(column, row);
  std::optional<double> first;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = column - 1; c <= column + 1; ++c) {
      if (!grid.has_cell(c, r) || std::isnan(arrival.at(c, r))) continue;
      first = std::min(first.value_or(arrival.at(c, r)), arrival.at(c, r));
    }
  }
  return first;
}

}  // namespace sabo
