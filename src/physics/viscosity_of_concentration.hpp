#pragma once

#include <cmath>

namespace sabo {

/// Plastic viscosity, Pa s, of a mixture with a concentration of solids by volume, percent:
/// mu_B = 0.621 exp(0.173 C), as the paper of 2016 uses it (1255 Pa s at 44 %).
inline double viscosity_of_concentration(double percent) {
  return 0.621 * std::exp(0.173 * percent);
}

}  // namespace sabo
