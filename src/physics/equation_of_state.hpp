#pragma once

#include <cmath>

#include "base/host_device.hpp"
#include "math/scalar.hpp"

namespace sabo {

/// Tait equation p = B ((rho/rho0)^7 - 1) with B = c0^2 rho0 / 7 (paper Eq. 14; its printed
/// c0^2 rho0 gamma is a misprint: dp/drho at rho0 must be c0^2).
struct Tait {
  double rho0;  ///< reference density, kg/m3
  double c0;    ///< sound speed at rho0, m/s

  SABO_HD constexpr double b() const { return c0 * c0 * rho0 / 7; }

  /// Pressure, Pa. The binomial is multiplied out in e = rho/rho0 - 1, which keeps the digits that
  /// (rho/rho0)^7 - 1 would cancel.
  SABO_HD constexpr double pressure(double rho) const {
    const double e = rho / rho0 - 1;
    return b() * e * (7 + e * (21 + e * (35 + e * (35 + e * (21 + e * (7 + e))))));
  }

  /// sqrt(dp/drho) at a density, m/s: the cube of rho/rho0 over that at rho0.
  SABO_HD constexpr double sound_speed(double rho) const {
    const double ratio = rho / rho0;
    return c0 * ratio * ratio * ratio;
  }

  /// Elastic energy, J/kg, zero at rho0: the integral of p / rho^2 from rho0 to rho > 0, which is
  /// what the pressure forces of Eq. 13 take from the motion. With x = rho/rho0,
  ///   p / rho^2 d rho = c0^2/7 (x^5 - 1/x^2) dx,   whose integral from 1 is
  ///   c0^2/7 ((x^6 - 1)/6 + 1/x - 1)
  ///   = c0^2 (x - 1)^2 (x^5 + 2x^4 + 3x^3 + 4x^2 + 5x + 6) / (42 x).
  /// The factored form keeps the digits that the other cancels; for x -> 1 it is that of a linear
  /// spring, c0^2 (x - 1)^2 / 2.
  SABO_HD constexpr double elastic_energy(double rho) const {
    const double x = rho / rho0;
    const double strain = (rho - rho0) / rho0;
    const double sum = 6 + x * (5 + x * (4 + x * (3 + x * (2 + x))));
    return c0 * c0 * strain * strain * sum / (42 * x);
  }

  /// Share of a negative pressure, and of the energy, of a density that a fluid bears which may be
  /// torn, by the pressure that it has.
  SABO_HD double borne_share(double rho, double its_pressure) const {
    const double whole = pressure(rho);
    return whole < 0 ? smaller(larger(its_pressure / whole, 0.0), 1.0) : 1;
  }

  /// Density at a pressure above -B, kg/m3.
  SABO_HD double density(double p) const { return rho0 * std::pow(1 + p / b(), 1.0 / 7); }
};

}  // namespace sabo
