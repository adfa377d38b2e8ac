#pragma once

#include "base/describe.hpp"
#include "base/host_device.hpp"
#include "physics/rheology/shear.hpp"

namespace sabo {

/// What the laws of Bingham's family share: plastic viscosity mu_B, and a cap ratio x mu_B where
/// the law itself is infinite or nearly so. The cap is a very viscous fluid in place of a solid:
/// the flow creeps at gd = tau / (ratio mu_B) below yield. It also bounds the time step.
struct Plastic {
  static constexpr bool has_yield = true;

  double mu_b = 1255;  ///< plastic viscosity, Pa s
  double ratio = 1e4;  ///< cap over plastic viscosity

  template <class V>
  void describe(V&& v) {
    v(Key{"viscosity", "Pa s", "plastic viscosity mu_B"}.above(0).at_most(1e9), mu_b);
    v(Key{"viscosity_ratio", "",
          "cap of the effective viscosity over mu_B; steps of method paper fall with it"}
          .at_least(1)
          .at_most(1e6),
      ratio);
  }

  SABO_HD double max_viscosity() const { return ratio * mu_b; }

  SABO_HD double capped(double viscosity) const {
    return viscosity < max_viscosity() ? viscosity : max_viscosity();
  }
};

}  // namespace sabo
