#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "analysis/columns.hpp"

namespace sabo {

/// The flow before a structure, from which design formulas take the load.
struct ApproachState {
  double depth = 0;         ///< greatest, m
  double speed = 0;         ///< greatest, m/s
  double depth_speed2 = 0;  ///< greatest product of depth and squared speed, m3/s2
  double surface = 0;       ///< highest elevation of the flow, m; of use where depth is not 0
};

/// The cells of a map that lie before a structure.
class Approach {
 public:
  /// Takes the cells whose centres `is_before(x, y)` picks. `elevation` without data is outside.
  Approach(const Raster& elevation, const std::function<bool(double x, double y)>& is_before);

  ApproachState measure(const Columns& columns) const;

 private:
  struct Cell {
    std::size_t index;
    double ground;  ///< m
  };
  std::vector<Cell> cells_;
};

/// Design formulas, N. Hydrostatic: density g depth^2 / 2 over the width.
double hydrostatic_load(double density, double gravity, double depth, double width);

/// alpha density depth speed^2 over the width. For debris flows on sabo dams alpha is 1 (NILIM
/// Technical Note 905, 2016: design of works against debris flow and driftwood).
double dynamic_load(double alpha, double density, double depth_speed2, double width);

}  // namespace sabo
