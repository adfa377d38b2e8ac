#pragma once

#include "base/host_device.hpp"
#include "physics/rheology/shear.hpp"
#include "physics/yield.hpp"

namespace sabo {

/// What a law sees at a shear rate (1/s) and pressure (Pa), `slope` being yield.slope(): for a law
/// without a yield stress the rate alone.
template <class Law>
SABO_HD inline Shear shear_state(double rate, double pressure, const MohrCoulomb& yield,
                                 double slope) {
  if constexpr (!Law::has_yield) return {rate};
  return {rate, yield(pressure, slope), yield.effective_pressure(pressure)};
}

}  // namespace sabo
