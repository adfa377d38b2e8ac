#pragma once

#include <cmath>
#include <numbers>

namespace sabo {

/// A Newtonian fluid between plates at z = 0 and z = length starts from rest (Morris, Fox & Zhu
/// 1997, J. Comput. Phys. 136, 214-226).
struct StartUp {
  double length = 1e-3;      ///< m
  double viscosity = 1e-6;   ///< nu, m2/s
  double body_force = 1e-4;  ///< F, m/s2
  double lid_speed =
      1.25e-5;  ///< V0, m/s; also F length^2 / (8 nu), the greatest speed of the first

  /// Plane Poiseuille flow, driven by the body force (their Eq. 23), m/s.
  double poiseuille(double z, double t) const {
    double u = body_force / (2 * viscosity) * z * (length - z);
    for (int n = 0; n < terms; ++n) {
      const double k = std::numbers::pi * (2 * n + 1) / length;
      u -= 4 * body_force / (viscosity * length * k * k * k) * std::sin(k * z) *
           std::exp(-k * k * viscosity * t);
    }
    return u;
  }

  /// Plane Couette flow, driven by the plate at z = length (their Eq. 22), m/s.
  double couette(double z, double t) const {
    double u = lid_speed * z / length;
    for (int n = 1; n < terms; ++n) {
      const double k = std::numbers::pi * n / length;
      u += 2 * lid_speed / (n * std::numbers::pi) * (n % 2 ? -1 : 1) * std::sin(k * z) *
           std::exp(-k * k * viscosity * t);
    }
    return u;
  }

 private:
  static constexpr int terms = 100;
};

}  // namespace sabo
