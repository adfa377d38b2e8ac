#pragma once

#include <algorithm>
#include <vector>

#include "physics/rheology_list.hpp"

namespace sabo {

/// Shear rate (1/s) at which a law carries a shear stress (Pa) with the yield stress and pressure
/// of `at`; for stresses that grow with the rate, by bisection.
inline double rate_at_stress(const Rheology& law, double stress, Shear at) {
  double low = 0, high = 1;
  const auto carried = [&](double rate) {
    at.rate = rate;
    return std::visit([&](const auto& l) { return l.viscosity(at); }, law) * rate;
  };
  if (!(stress > 0)) return 0;
  while (carried(high) < stress) high *= 2;
  for (int k = 0; k < 200 && high - low > 1e-14 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (carried(middle) < stress ? low : high) = middle;
  }
  return high;
}

/// Steady flow along a wall at z = 0 whose shear stress and pressure are known at every height:
/// the law's own shear rate, integrated from the wall (trapezoidal rule).
class ShearFlow {
 public:
  /// `at(z)`: yield stress and pressure; `stress(z)`: shear stress, Pa, 0 at z = height.
  template <class Stress, class At>
  ShearFlow(const Rheology& law, double height, const Stress& stress, const At& at)
      : height_(height), speed_(cells + 1, 0.0) {
    double below = rate_at_stress(law, stress(0.0), at(0.0));
    for (int k = 1; k <= cells; ++k) {
      const double z = height * k / cells;
      const double rate = rate_at_stress(law, stress(z), at(z));
      speed_[k] = speed_[k - 1] + 0.5 * (below + rate) * height / cells;
      below = rate;
    }
  }

  /// m/s, z in m; 0 below the wall, that of the top above it.
  double operator()(double z) const {
    const double place = std::clamp(z / height_, 0.0, 1.0) * cells;
    const int k = std::min(static_cast<int>(place), cells - 1);
    return speed_[k] + (place - k) * (speed_[k + 1] - speed_[k]);
  }
  double top() const { return speed_.back(); }
  double mean() const {
    double sum = 0;
    for (int k = 0; k < cells; ++k) sum += 0.5 * (speed_[k] + speed_[k + 1]) / cells;
    return sum;
  }

 private:
  static constexpr int cells = 2000;

  double height_;
  std::vector<double> speed_;
};

}  // namespace sabo
