#pragma once

#include "physics/rheology/plastic.hpp"

namespace sabo {

/// Quadratic law of O'Brien & Julien (1985): tau = tau_B + mu_B gd + C gd^2, of which the last term
/// stands for turbulence and for collisions of grains. mu_eff = tau / gd up to the cap, which
/// bounds it at rest and, far beyond debris flows, at shear rates near ratio mu_B / C.
struct Quadratic : Plastic {
  static constexpr const char* name = "quadratic";
  static constexpr const char* summary =
      "yield, viscous and quadratic (turbulent, dispersive) stress";

  double c = 1;  ///< Pa s2

  template <class V>
  void describe(V&& v) {
    Plastic::describe(v);
    v(Key{"quadratic_coefficient", "Pa s2",
          "C in C x (shear rate)^2: rho_m l_m^2 + 0.01 rho_s (lambda d_s)^2"}
          .at_least(0)
          .at_most(1e6),
      c);
  }

  SABO_HD double viscosity(const Shear& at) const {
    const double cap = max_viscosity();
    const double stress = at.yield_stress + (mu_b + c * at.rate) * at.rate;
    return stress < cap * at.rate ? stress / at.rate : (stress > 0 ? cap : mu_b);
  }
};

}  // namespace sabo
