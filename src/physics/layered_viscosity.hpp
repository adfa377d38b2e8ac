#pragma once

#include "physics/kernel.hpp"
#include "physics/plane_integral.hpp"

namespace sabo {

/// Viscosity that the two-point form (Morris et al. 1997) gives a shear flow of layers of particles
/// a spacing apart, as a share of that of the fluid. Layers that slide over each other meet at all
/// places, so that along them sums are integrals; across them the integral of -F z^2, which is 1,
/// is left to a sum over few layers. In two dimensions 0.963 at h/dp = 1.2 and 0.997 at 1.5, in
/// three 0.979 and 0.999, whatever the resolution.
inline double layered_viscosity(const WendlandC2<double>& kernel, int dimension, double spacing) {
  double sum = 0;
  for (double z = spacing; z < kernel.radius(); z += spacing) {
    const auto steepness = [&](double r) { return -kernel.gradient_factor(r); };
    sum += 2 * spacing * z * z * plane_integral(steepness, kernel.radius(), dimension, z);
  }
  return sum;
}

}  // namespace sabo
