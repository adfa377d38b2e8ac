#pragma once

#include <cmath>

#include "base/describe.hpp"
#include "base/host_device.hpp"
#include "physics/rheology/shear.hpp"

namespace sabo {

/// Cross fluid fed by Bingham parameters (paper Eqs. 21-26): K = mu_0 / tau_B, mu_inf = mu_B and
/// mu_0 = ratio x mu_inf. For m = 1 the stress is tau_B + mu_B gd once gd >> tau_B / mu_0; below
/// yield the fluid creeps.
struct Cross {
  static constexpr const char* name = "cross";
  static constexpr const char* summary = "Cross fluid from Bingham or Mohr-Coulomb parameters";
  static constexpr bool has_yield = true;

  double mu_inf = 1255;  ///< plastic viscosity mu_B, Pa s
  double ratio = 1e4;    ///< mu_0 / mu_inf; the paper has 1000
  double m = 1;          ///< exponent

  template <class V>
  void describe(V&& v) {
    v(Key{"viscosity", "Pa s", "plastic viscosity mu_B, the viscosity at high shear rate"}
          .above(0)
          .at_most(1e9),
      mu_inf);
    v(Key{"viscosity_ratio", "",
          "viscosity at rest mu_0 over mu_B; creep falls with it, and so do the steps of method "
          "paper (the paper has 1000)"}
          .at_least(1)
          .at_most(1e6),
      ratio);
    v(Key{"exponent", "", "m of the general Cross law"}.above(0).at_most(10), m);
  }

  /// mu_inf + (mu_0 - mu_inf) tau_B^m / (tau_B^m + (mu_0 gd)^m): Eq. 21 with K = mu_0 / tau_B
  /// multiplied out, so that tau_B -> 0 is harmless. Both arguments zero give mu_inf.
  SABO_HD double viscosity(const Shear& at) const {
    using std::pow;
    const double viscous = max_viscosity() * at.rate;
    const double larger = viscous > at.yield_stress ? viscous : at.yield_stress;
    if (!(larger > 0)) return mu_inf;
    const double a = viscous / larger;  // in [0, 1], one of the two is 1
    const double b = at.yield_stress / larger;
    const double bm = m == 1 ? b : pow(b, m);
    const double am = m == 1 ? a : pow(a, m);
    return mu_inf + (max_viscosity() - mu_inf) * bm / (bm + am);
  }
  SABO_HD double max_viscosity() const { return ratio * mu_inf; }
};

}  // namespace sabo
