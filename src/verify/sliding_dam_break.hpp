#pragma once

#include <cmath>

namespace sabo {

/// A layer of depth h0 on a slope lets go at x = 0 and slides on a dry bed, averaged over the depth
/// (Mangeney, Heinrich & Roche 2000): h = (2 c0 - x/t + m t/2)^2 / (9 g cos(slope)) with c0 =
/// sqrt(g cos(slope) h0) and m the part of gravity that friction leaves.
struct SlidingDamBreak {
  double g, slope, friction;  ///< m/s2; angles in rad
  double h0;                  ///< m

  /// Where the depth is `depth` (m) at the time t (s), m.
  double place(double t, double depth) const {
    const double normal = g * std::cos(slope);
    const double m = g * std::sin(slope) - normal * std::tan(friction);
    return t * (2 * std::sqrt(normal * h0) + m * t / 2 - 3 * std::sqrt(normal * depth));
  }
};

}  // namespace sabo
