#pragma once

#include "physics/rheology/plastic.hpp"

namespace sabo {

/// Bingham fluid whose plastic part does not grow below a threshold of the shear rate (Laigle,
/// Lachamp & Naaim 2007): mu_eff = mu_B + tau_B / max(gd, gd_c), up to the cap.
struct Threshold : Plastic {
  static constexpr const char* name = "threshold";
  static constexpr const char* summary = "Bingham fluid, Newtonian below a threshold of shear rate";

  double threshold = 0.01;  ///< gd_c, 1/s

  template <class V>
  void describe(V&& v) {
    Plastic::describe(v);
    v(Key{"rate_threshold", "1/s", "gd_c, shear rate below which the viscosity is constant"}
          .above(0)
          .at_most(1e6),
      threshold);
  }

  SABO_HD double viscosity(const Shear& at) const {
    return capped(mu_b + at.yield_stress / (at.rate > threshold ? at.rate : threshold));
  }
};

}  // namespace sabo
