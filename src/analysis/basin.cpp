#include "analysis/basin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "analysis/curtain.hpp"

namespace sabo {
namespace {

double lowest_top(const CheckDam& dam) {
  double lowest = std::numeric_limits<double>::infinity();
  const std::vector<double> stations = dam_stations(dam);
  for (std::size_t k = 0; k + 1 < stations.size(); ++k)
    for (const double station : {stations[k], (stations[k] + stations[k + 1]) / 2, stations[k + 1]})
      lowest = std::min(lowest, dam.top(station));
  return lowest;
}

}  // namespace

Basin::Basin(const Raster& elevation, const CheckDam& dam, int side)
    : level_(lowest_top(dam)), cell_area_(elevation.grid.cell_area()) {
  find_shore(elevation, dam, side);
  if (shore_.empty()) return;
  foot_ = std::ranges::min(shore_, {}, &Cell::ground).ground;
  fill(elevation, dam);
  for (const Cell& cell : pool_) capacity_ += (level_ - cell.ground) * cell_area_;
}

/// The cells nearest to the face of the dam.
void Basin::find_shore(const Raster& elevation, const CheckDam& dam, int side) {
  const Grid& grid = elevation.grid;
  const double span = length(dam.axis);
  const double reach = dam.thickness / 2 + std::hypot(grid.dx, grid.dy);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t index = grid.index(column, row);
      const double ground = elevation.values[index];
      if (std::isnan(ground)) continue;
      const LinePlace place = project(dam.axis, grid.x_of(column), grid.y_of(row));
      const double distance = side * place.offset;
      if (place.station >= 0 && place.station <= span && distance >= dam.thickness / 2 &&
          distance <= reach)
        shore_.push_back({index, ground});
    }
}

/// Lets the pool grow from the foot of the dam into its lowest neighbour each time. The water
/// stands as high as the highest ground that it has had to pass: if it reaches the end of the map,
/// it is drained at that height, and what it covered before it passed is the pool.
void Basin::fill(const Raster& elevation, const CheckDam& dam) {
  const Grid& grid = elevation.grid;
  const Curtain wall(dam.axis);
  const auto place = [&](std::size_t index) {
    const int row = grid.row_at(index);
    const int column = grid.column_at(index);
    return Vec3d{grid.x_of(column), grid.y_of(row), 0};
  };
  const auto is_higher = [](const Cell& a, const Cell& b) { return a.ground > b.ground; };
  std::priority_queue<Cell, std::vector<Cell>, decltype(is_higher)> shores(is_higher);
  std::vector<char> is_seen(grid.size());
  const Cell foot = std::ranges::min(shore_, {}, &Cell::ground);
  shores.push(foot);
  is_seen[foot.index] = 1;
  double water = foot.ground;
  std::size_t before_saddle = 0;
  while (!shores.empty() && shores.top().ground < level_) {
    const Cell cell = shores.top();
    shores.pop();
    if (cell.ground > water) {
      water = cell.ground;
      before_saddle = pool_.size();
    }
    pool_.push_back(cell);
    const int row = grid.row_at(cell.index);
    const int column = grid.column_at(cell.index);
    for (const auto [east, south] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const bool is_inside = grid.has_cell(column + east, row + south);
      const std::size_t next = is_inside ? grid.index(column + east, row + south) : 0;
      if (!is_inside || std::isnan(elevation.values[next])) {
        level_ = water;
        is_flanked_ = true;
        pool_.resize(before_saddle);
        return;
      }
      const Vec3d to = place(next);
      const LinePlace at = project(dam.axis, to.x, to.y);
      const bool is_in_wall = std::abs(at.offset) < dam.thickness / 2 && at.station >= 0 &&
                              at.station <= length(dam.axis);
      if (is_seen[next] || is_in_wall || wall.crossings(place(cell.index), to) != 0) continue;
      is_seen[next] = 1;
      shores.push({next, elevation.values[next]});
    }
  }
}

BasinState Basin::measure(const Columns& columns) const {
  BasinState state;
  for (const Cell& cell : pool_)
    state.stored += std::min(columns.depth(cell.index), level_ - cell.ground) * cell_area_;
  if (capacity_ > 0) state.filled = state.stored / capacity_;
  double sum = 0, weight = 0;
  for (const Cell& cell : shore_) {
    if (!columns.is_wet(cell.index)) continue;
    const double depth = columns.depth(cell.index);  // films on the banks count for little
    sum += depth * (cell.ground + depth);
    weight += depth;
  }
  state.surface = weight > 0 ? sum / weight : foot_;
  return state;
}

}  // namespace sabo
