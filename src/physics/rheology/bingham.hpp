#pragma once

#include "physics/rheology/plastic.hpp"

namespace sabo {

/// Exact Bingham fluid (Bingham 1922; paper Eq. 20 and figure 1): mu_eff = mu_B + tau_B / gd, up to
/// the cap.
struct Bingham : Plastic {
  static constexpr const char* name = "bingham";
  static constexpr const char* summary = "exact Bingham fluid with capped viscosity";

  SABO_HD double viscosity(const Shear& at) const {
    const double cap = max_viscosity();
    const double stress = mu_b * at.rate + at.yield_stress;
    return stress < cap * at.rate ? stress / at.rate : (at.yield_stress > 0 ? cap : mu_b);
  }
};

}  // namespace sabo
