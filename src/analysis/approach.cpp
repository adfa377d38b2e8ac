#include "analysis/approach.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

Approach::Approach(const Raster& elevation,
                   const std::function<bool(double x, double y)>& is_before) {
  const Grid& grid = elevation.grid;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t index = grid.index(column, row);
      const double ground = elevation.values[index];
      if (!std::isnan(ground) && is_before(grid.x_of(column), grid.y_of(row)))
        cells_.push_back({index, ground});
    }
}

ApproachState Approach::measure(const Columns& columns) const {
  ApproachState state;
  for (const Cell& cell : cells_) {
    if (!columns.is_wet(cell.index)) continue;
    const double depth = columns.depth(cell.index), speed = columns.speed(cell.index);
    const double surface = cell.ground + depth;
    if (state.depth == 0 || surface > state.surface) state.surface = surface;
    state.depth = std::max(state.depth, depth);
    state.speed = std::max(state.speed, speed);
    state.depth_speed2 = std::max(state.depth_speed2, depth * speed * speed);
  }
  return state;
}

double hydrostatic_load(double density, double gravity, double depth, double width) {
  return 0.5 * density * gravity * depth * depth * width;
}

double dynamic_load(double alpha, double density, double depth_speed2, double width) {
  return alpha * density * depth_speed2 * width;
}

}  // namespace sabo
