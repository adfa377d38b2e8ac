#pragma once

#include "base/describe.hpp"
#include "base/host_device.hpp"

namespace sabo {

/// Exact Bingham fluid, mu_eff = mu_B + tau_B / gd, capped at ratio x mu_B where the exact law is
/// infinite (paper Eq. 20 and figure 1). The cap is a very viscous fluid in place of a solid: the
/// flow creeps at gd = tau / (ratio mu_B) below yield.
struct Bingham {
  static constexpr const char* name = "bingham";
  static constexpr const char* summary = "exact Bingham fluid with capped viscosity";
  static constexpr bool has_yield = true;

  double mu_b = 1255;   ///< plastic viscosity, Pa s
  double ratio = 1000;  ///< cap over plastic viscosity

  template <class V>
  void describe(V&& v) {
    v(Key{"viscosity", "Pa s", "plastic viscosity mu_B"}.above(0).at_most(1e9), mu_b);
    v(Key{"viscosity_ratio", "", "cap of the effective viscosity over mu_B"}.at_least(1).at_most(
          1e6),
      ratio);
  }

  SABO_HD double viscosity(double shear_rate, double yield_stress) const {
    const double cap = max_viscosity();
    const double uncapped = mu_b * shear_rate + yield_stress;  // the stress
    return uncapped < cap * shear_rate ? uncapped / shear_rate : (yield_stress > 0 ? cap : mu_b);
  }
  SABO_HD double max_viscosity() const { return ratio * mu_b; }
};

}  // namespace sabo
