#pragma once

#include "physics/rheology/plastic.hpp"

namespace sabo {

/// Bingham fluid with the simple regularisation that Frigaard & Nouar (2005) analyse:
/// mu_eff = mu_B + tau_B / (gd + eps), up to the cap. For gd << eps it is Newtonian with
/// mu_B + tau_B / eps.
struct FrigaardNouar : Plastic {
  static constexpr const char* name = "frigaard_nouar";
  static constexpr const char* summary =
      "Bingham fluid, regularised by an offset of the shear rate";

  double offset = 0.01;  ///< eps, 1/s

  template <class V>
  void describe(V&& v) {
    Plastic::describe(v);
    v(Key{"rate_offset", "1/s", "eps in tau_B / (shear rate + eps)"}.above(0).at_most(1e6), offset);
  }

  SABO_HD double viscosity(const Shear& at) const {
    return capped(mu_b + at.yield_stress / (at.rate + offset));
  }
};

}  // namespace sabo
