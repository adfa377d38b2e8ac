#pragma once

#include "base/describe.hpp"
#include "base/host_device.hpp"
#include "physics/rheology/shear.hpp"

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

  SABO_HD double viscosity(const Shear&) const { return mu; }
  SABO_HD double max_viscosity() const { return mu; }
};

}  // namespace sabo
