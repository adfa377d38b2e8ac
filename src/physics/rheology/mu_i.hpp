#pragma once

#include <cmath>

#include "base/describe.hpp"
#include "base/host_device.hpp"
#include "physics/rheology/shear.hpp"

namespace sabo {

/// Dense granular flow, mu(I) (Jop, Forterre & Pouliquen 2006):
///   tau = mu(I) p' + eta gd,
///   mu(I) = mu_s + (mu_2 - mu_s) / (1 + I_0/I),
///   I = gd d / sqrt(p'/rho_s)
/// with the effective pressure p'. The static part, c + mu_s p', is the yield stress, mu_s the
/// tangent of its friction angle. eta, the viscosity of the fluid between the grains, keeps places
/// without pressure calm. mu_eff = tau / gd, up to the cap.
struct MuI {
  static constexpr const char* name = "mu_i";
  static constexpr const char* summary =
      "dense granular flow, mu(I): friction that grows with the inertial number";
  static constexpr bool has_yield = true;

  double increase = 0.26;       ///< mu_2 - mu_s
  double i_0 = 0.279;           ///< I_0
  double diameter = 0.01;       ///< d, m
  double grain_density = 2650;  ///< rho_s, kg/m3
  double eta = 1;               ///< Pa s
  double cap = 1e6;             ///< Pa s

  template <class V>
  void describe(V&& v) {
    v(Key{"friction_increase", "",
          "mu_2 - mu_s, of the friction coefficient from rest to fast flow"}
          .at_least(0)
          .at_most(10),
      increase);
    v(Key{"inertial_number", "", "I_0, at which half of that increase is reached"}.above(0).at_most(
          100),
      i_0);
    v(Key{"grain_diameter", "m", "d in the inertial number"}.above(0).at_most(10), diameter);
    v(Key{"grain_density", "kg/m3", "rho_s in the inertial number"}.at_least(100).at_most(3e4),
      grain_density);
    v(Key{"fluid_viscosity", "Pa s", "eta, of the fluid between the grains"}.at_least(0).at_most(
          1e9),
      eta);
    v(Key{"greatest_viscosity", "Pa s", "cap of the effective viscosity"}.above(0).at_most(1e12),
      cap);
  }

  SABO_HD double viscosity(const Shear& at) const {
    using std::sqrt;
    // I / (I + I_0), multiplied by sqrt(p'/rho_s), so that p' -> 0 is harmless.
    const double inertia = at.rate * diameter;
    const double fast_share =
        inertia > 0 ? inertia / (inertia + i_0 * sqrt(at.pressure / grain_density)) : 0;
    const double stress = at.yield_stress + increase * at.pressure * fast_share + eta * at.rate;
    return stress < cap * at.rate ? stress / at.rate : (stress > 0 || eta > cap ? cap : eta);
  }
  SABO_HD double max_viscosity() const { return cap; }
};

}  // namespace sabo
