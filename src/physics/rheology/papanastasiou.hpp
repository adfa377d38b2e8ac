#pragma once

#include "physics/rheology/exponential_rise.hpp"
#include "physics/rheology/plastic.hpp"

namespace sabo {

/// Bingham fluid whose yield stress rises smoothly from rest (Papanastasiou 1987):
/// mu_eff = mu_B + tau_B (1 - exp(-m gd)) / gd, up to the cap; mu_B + m tau_B at rest.
struct Papanastasiou : Plastic {
  static constexpr const char* name = "papanastasiou";
  static constexpr const char* summary = "Bingham fluid, regularised by an exponential";

  double m = 100;  ///< s

  template <class V>
  void describe(V&& v) {
    Plastic::describe(v);
    v(Key{"regularisation_time", "s", "m in 1 - exp(-m x shear rate)"}.above(0).at_most(1e9), m);
  }

  SABO_HD double viscosity(const Shear& at) const {
    return capped(mu_b + at.yield_stress * exponential_rise(at.rate, m));
  }
};

}  // namespace sabo
