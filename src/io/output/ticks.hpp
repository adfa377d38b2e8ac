#pragma once

#include <string>
#include <vector>

namespace sabo {

/// The largest of 1, 2, 5 x 10^n that is not above `value` (> 0).
double round_down(double value);

/// Round numbers along an axis.
struct Ticks {
  double step = 1;
  std::vector<double> values;  ///< multiples of `step`; the first is at or below the smallest data,
                               ///< the last at or above the largest

  double first() const { return values.front(); }
  double last() const { return values.back(); }
  /// With as many decimals as the step needs, a true minus sign.
  std::string label(double value) const;
};

/// Ticks from at or below `low` to at or above `high` with a step of 1, 2 or 5 x 10^n, about
/// `count` of them. Any finite numbers will do, equal ones too.
Ticks ticks_over(double low, double high, int count);

}  // namespace sabo
