#pragma once

#include <cmath>
#include <numbers>

namespace sabo {

/// Shape at rest with the stress along the bed, to first order in b = tau_y/(rho g) over the height
/// (Dubash, Balmforth, Slim & Cochard 2009): h dh/dx = -b (1 + (pi/2) b/(h - pi b/2) ...), whose
/// integral is h = pi b/2 + sqrt(pi^2 b^2/4 + 2 b (L - x)); it ends in a front of height pi b.
struct SlumpAtRest {
  double b;  ///< m

  double front() const { return 2 * foot(); }  ///< its height, m
  double height(double below) const {          ///< at the distance L - x from the front, m
    return foot() + std::sqrt(foot() * foot() + 2 * b * below);
  }
  double volume(double length) const {  ///< of a half, m2
    const double root = height(length) - foot();
    return foot() * length + (std::pow(root, 3) - std::pow(foot(), 3)) / (3 * b);
  }
  /// L, that a volume (m2, of a half) fills, m.
  double length(double filled) const {
    double low = 0, high = 1;
    while (volume(high) < filled) high *= 2;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (volume(middle) < filled ? low : high) = middle;
    }
    return low;
  }

 private:
  double foot() const { return std::numbers::pi * b / 2; }
};

}  // namespace sabo
