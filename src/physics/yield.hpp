#pragma once

#include <cmath>
#include <numbers>

#include "base/describe.hpp"
#include "base/host_device.hpp"

namespace sabo {

/// Mohr-Coulomb yield stress with a pore pressure ratio (paper Eq. 25; Iverson 1997 for r_u):
/// tau_B = c + (1 - r_u) max(p, 0) tan(phi). phi = 0 gives a constant yield stress.
struct MohrCoulomb {
  double cohesion = 0;             ///< Pa
  double friction_angle = 0;       ///< degrees
  double pore_pressure_ratio = 0;  ///< share of the normal stress carried by pore water

  template <class V>
  void describe(V&& v) {
    v(Key{"cohesion", "Pa", "yield stress without normal stress"}.at_least(0).at_most(1e9),
      cohesion);
    v(Key{"friction_angle", "deg", "internal friction angle phi"}.at_least(0).at_most(60),
      friction_angle);
    v(Key{"pore_pressure_ratio", "", "r_u, share of the normal stress carried by pore water"}
          .at_least(0)
          .at_most(1),
      pore_pressure_ratio);
  }

  /// Pa per Pa of pressure.
  SABO_HD double slope() const {
    return (1 - pore_pressure_ratio) * std::tan(friction_angle * std::numbers::pi / 180);
  }

  /// Pressure between the grains at pressure p, Pa; suction counts as none.
  SABO_HD double effective_pressure(double p) const {
    return (1 - pore_pressure_ratio) * (p > 0 ? p : 0);
  }

  /// Yield stress at pressure p, Pa; suction adds nothing. `slope_value` is slope(), which is the
  /// same for all particles.
  SABO_HD double operator()(double p, double slope_value) const {
    return cohesion + slope_value * (p > 0 ? p : 0);
  }
};

}  // namespace sabo
