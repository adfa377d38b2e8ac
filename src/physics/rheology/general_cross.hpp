#pragma once

#include <cmath>

#include "base/describe.hpp"
#include "base/host_device.hpp"
#include "physics/rheology/shear.hpp"

namespace sabo {

/// General Cross fluid (paper Eq. 21; Cross 1965):
/// mu_eff = (mu_0 + (K gd)^m mu_inf) / (1 + (K gd)^m).
struct GeneralCross {
  static constexpr const char* name = "general_cross";
  static constexpr const char* summary = "Cross fluid from its four own parameters";
  static constexpr bool has_yield = false;

  double mu_0 = 1000;  ///< viscosity at rest, Pa s
  double mu_inf = 1;   ///< viscosity at high shear rate, Pa s
  double k = 1;        ///< K, s
  double m = 1;        ///< exponent

  template <class V>
  void describe(V&& v) {
    v(Key{"viscosity_at_rest", "Pa s", "mu_0, at vanishing shear rate"}.above(0).at_most(1e12),
      mu_0);
    v(Key{"viscosity", "Pa s", "mu_inf, at high shear rate"}.at_least(0).at_most(1e9), mu_inf);
    v(Key{"time_constant", "s", "K: 1/K is the shear rate of the transition"}.at_least(0).at_most(
          1e9),
      k);
    v(Key{"exponent", "", "m, steepness of the transition"}.above(0).at_most(10), m);
  }

  /// Written as mu_inf + (mu_0 - mu_inf) / (1 + x), which holds where x overflows to infinity.
  SABO_HD double viscosity(const Shear& at) const {
    using std::pow;
    return mu_inf + (mu_0 - mu_inf) / (1 + pow(k * at.rate, m));
  }
  SABO_HD double max_viscosity() const { return mu_0 > mu_inf ? mu_0 : mu_inf; }
};

}  // namespace sabo
