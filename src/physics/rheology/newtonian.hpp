#pragma once

#include "base/describe.hpp"
#include "base/host_device.hpp"

namespace sabo {

/// Constant viscosity.
struct Newtonian {
  static constexpr const char* name = "newtonian";
  static constexpr const char* summary = "constant viscosity";
  static constexpr bool has_yield = false;

  double mu = 0.001;  ///< Pa s

  template <class V>
  void describe(V&& v) {
    v(Key{"viscosity", "Pa s", "dynamic viscosity"}.at_least(0).at_most(1e9), mu);
  }

  SABO_HD double viscosity(double /*shear_rate*/, double /*yield_stress*/) const { return mu; }
  SABO_HD double max_viscosity() const { return mu; }
};

}  // namespace sabo
