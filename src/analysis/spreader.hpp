#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/raster.hpp"

namespace sabo {

/// Spreads an amount at a point over the cells of a grid, conservatively: over a rectangle around
/// the point with sides max(cell, 2 spacings), in proportion to its exact overlap with each cell.
/// Cells outside the domain take nothing, and the shares of the others are raised to sum to one;
/// where the rectangle meets no cell of the domain, the nearest one takes all.
class Spreader {
 public:
  /// Cells where `elevation` is NaN are outside the domain. `spacing` is that of the particles, m.
  Spreader(const Raster& elevation, double spacing);

  /// Calls add(index of the cell, share) for each cell that takes a positive share. No call if the
  /// grid has no cell in the domain.
  template <class Add>
  void spread(double x, double y, Add&& add) const;

  const Grid& grid() const { return grid_; }
  bool is_inside(std::size_t cell) const { return inside_[cell] != 0; }

 private:
  /// Cells [first, last] met by an interval, in cell units from the edge of cell 0; empty if none.
  struct Range {
    double from;
    double to;
    int first;
    int last;
    double overlap(int cell) const { return std::min(to, cell + 1.0) - std::max(from, cell + 0.0); }
  };

  static Range range(double centre, double width, int cells);
  std::size_t nearest_inside(double x, double y) const;

  Grid grid_;
  std::vector<std::uint8_t> inside_;
  bool has_inside_;
  double width_;  // sides of the rectangle, in cells
  double height_;
};

template <class Add>
void Spreader::spread(double x, double y, Add&& add) const {
  const Range columns = range((x - grid_.west) / grid_.dx, width_, grid_.columns);
  const Range rows = range((grid_.north - y) / grid_.dy, height_, grid_.rows);
  double total = 0;
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) {
      if (is_inside(grid_.index(column, row))) total += columns.overlap(column) * rows.overlap(row);
    }
  }
  if (!(total > 0)) {
    if (has_inside_) add(nearest_inside(x, y), 1.0);
    return;
  }
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) {
      const std::size_t cell = grid_.index(column, row);
      if (!is_inside(cell)) continue;
      const double share = columns.overlap(column) * rows.overlap(row) / total;
      if (share > 0) add(cell, share);
    }
  }
}

}  // namespace sabo
