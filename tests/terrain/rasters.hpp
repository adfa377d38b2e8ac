#pragma once

#include <cmath>
#include <cstdint>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// Raster of a function of x and y, sampled at the cell centres.
template <class Function>
Raster raster_of(const Grid& grid, Function&& function) {
  Raster raster(grid);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      raster.at(column, row) = function(grid.x_of(column), grid.y_of(row));
    }
  }
  return raster;
}

/// Square grid whose cell centres reach from `low` to `high` on both axes.
inline Grid square_grid(double low, double high, double cell) {
  const int cells = static_cast<int>(std::lround((high - low) / cell)) + 1;
  return {cells, cells, low - cell / 2, high + cell / 2, cell, cell};
}

/// Level ground at 0, 60 m wide, about the origin.
inline Surface flat() { return Surface(Raster(square_grid(-30, 30, 1), 0)); }

/// A square from (low, low) to (high, high).
inline Polygon square(double low, double high) {
  return {{{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}}};
}

/// Repeatable numbers in [0, 1).
class Random {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }

 private:
  std::uint64_t state_ = 2463534242;
};

}  // namespace sabo
