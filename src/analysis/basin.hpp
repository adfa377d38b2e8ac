#pragma once

#include <cstddef>
#include <vector>

#include "analysis/columns.hpp"
#include "terrain/check_dam.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// What of a basin is full at one moment.
struct BasinState {
  double stored = 0;   ///< volume below the level of the sill, m3
  double filled = 0;   ///< its share of the capacity; 0 where there is no capacity
  double surface = 0;  ///< elevation of the surface at the dam, mean by depth; while it is dry of
                       ///< the lowest ground there, m
};

/// The room behind a dam below a level pool that would just not flow over: its nominal capacity.
/// Deposits of debris flows slope, so a dam may hold more than that.
class Basin {
 public:
  /// Behind a wall with no openings, on its left (`side` 1) or right (-1) looking along its axis.
  /// The map ends where `elevation` has no data; a pool that reaches its end is drained there.
  Basin(const Raster& elevation, const CheckDam& dam, int side);

  /// Elevation of the pool, m: of the lowest top of the dam, or of the saddle beside it that is
  /// lower.
  double level() const { return level_; }
  /// Whether the pool would leave by such a saddle before it reached the top of the dam.
  bool is_flanked() const { return is_flanked_; }
  double capacity() const { return capacity_; }  ///< m3
  /// Lowest ground at the dam, m.
  double foot() const { return foot_; }

  BasinState measure(const Columns& columns) const;

 private:
  struct Cell {
    std::size_t index;
    double ground;  ///< m
  };
  void find_shore(const Raster& elevation, const CheckDam& dam, int side);
  void fill(const Raster& elevation, const CheckDam& dam);

  double level_ = 0;
  double foot_ = 0;
  double capacity_ = 0;
  double cell_area_;
  bool is_flanked_ = false;
  std::vector<Cell> shore_;  ///< at the dam
  std::vector<Cell> pool_;
};

}  // namespace sabo
