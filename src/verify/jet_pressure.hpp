#pragma once

#include <cmath>
#include <numbers>

namespace sabo {

/// Pressure of a plane jet on a wide plate across it over rho u^2 / 2, at a distance from the
/// middle over the thickness b of the jet (free streamlines: Milne-Thomson, Theoretical
/// Hydrodynamics, chapter XI). Along it the jet has the speed q u at x/b = 2/pi (artanh q + arctan
/// q), and p = 1 - q^2. Its sum is 2 b, which is F = rho b u^2.
inline double jet_pressure(double place) {
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double q = 0.5 * (low + high);
    (2 / std::numbers::pi * (std::atanh(q) + std::atan(q)) < place ? low : high) = q;
  }
  return 1 - low * low;
}

}  // namespace sabo
