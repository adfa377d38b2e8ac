#pragma once

#include <cmath>

#include "base/describe.hpp"
#include "physics/rheology/exponential_rise.hpp"
#include "physics/rheology/shear.hpp"

namespace sabo {

/// Fluid of Herschel & Bulkley (1926) with Papanastasiou's regularisation:
/// mu_eff = k gd^(n-1) + tau_B (1 - exp(-m gd)) / gd, up to the cap, which a shear-thinning fluid
/// (n < 1) needs at rest even without a yield stress.
struct HerschelBulkley {
  static constexpr const char* name = "herschel_bulkley";
  static constexpr const char* summary =
      "Herschel-Bulkley-Papanastasiou fluid: yield stress and a power of the shear rate";
  static constexpr bool has_yield = true;

  double k = 100;     ///< consistency, Pa s^n
  double n = 1. / 3;  ///< exponent
  double m = 100;     ///< s
  double cap = 1e6;   ///< Pa s

  template <class V>
  void describe(V&& v) {
    v(Key{"consistency", "Pa s^n", "k in k x (shear rate)^n"}.above(0).at_most(1e9), k);
    v(Key{"exponent", "", "n; muds are shear-thinning, with n near 1/3"}.above(0).at_most(10), n);
    v(Key{"regularisation_time", "s", "m in 1 - exp(-m x shear rate)"}.above(0).at_most(1e9), m);
    v(Key{"greatest_viscosity", "Pa s", "cap of the effective viscosity"}.above(0).at_most(1e12),
      cap);
  }

  SABO_HD double viscosity(const Shear& at) const {
    using std::pow;
    const double viscous = n == 1 ? k : k * pow(at.rate, n - 1);
    const double uncapped = viscous + at.yield_stress * exponential_rise(at.rate, m);
    return uncapped < cap ? uncapped : cap;
  }
  SABO_HD double max_viscosity() const { return cap; }
};

}  // namespace sabo
