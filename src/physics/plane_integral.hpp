#pragma once

#include <cmath>
#include <numbers>

namespace sabo {

/// Integral of f(r) over a plane (a line in two dimensions) at the distance z from the origin of r,
/// out to r = `radius`, by the midpoint rule.
template <class F>
double plane_integral(const F& f, double radius, int dimension, double z) {
  constexpr int steps = 400;
  constexpr double pi = std::numbers::pi;
  const double most = std::sqrt(radius * radius - z * z);
  const double ds = most / steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double s = (k + 0.5) * ds;
    sum += f(std::sqrt(z * z + s * s)) * (dimension == 2 ? 2 : 2 * pi * s) * ds;
  }
  return sum;
}

}  // namespace sabo
