#pragma once

namespace sabo {

/// What the effective viscosity at a place may depend on.
struct Shear {
  double rate = 0;          ///< gd, engineering shear rate, 1/s
  double yield_stress = 0;  ///< tau_B, Pa
  double pressure = 0;      ///< effective, (1 - r_u) max(p, 0), Pa
};

}  // namespace sabo
