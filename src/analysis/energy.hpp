#pragma once

#include "particles/particles.hpp"
#include "physics/equation_of_state.hpp"

namespace sabo {

/// Mass (kg) and energies (J) of a set of particles.
struct Energy {
  double mass = 0;
  double kinetic = 0;
  double potential = 0;  ///< - m g.x: zero at the origin of the frame
  double elastic = 0;    ///< stored by compression; zero at the reference density
  double total() const { return kinetic + potential + elastic; }
};

/// Elastic energy of a Tait fluid, J/kg: the integral of p / rho^2 from rho0 to rho > 0, which is
/// what the pressure forces of Eq. 13 take from the motion. With x = rho/rho0,
///   p / rho^2 d rho = c0^2/7 (x^5 - 1/x^2) dx,   whose integral from 1 is
///   c0^2/7 ((x^6 - 1)/6 + 1/x - 1) = c0^2 (x - 1)^2 (x^5 + 2x^4 + 3x^3 + 4x^2 + 5x + 6) / (42 x).
/// The factored form keeps the digits that the other cancels; for x -> 1 it is c0^2 (x - 1)^2 / 2,
/// that of a linear spring.
double elastic_energy(const Tait& tait, double density);

/// Sums over the rows in fixed blocks. `gravity` in m/s2.
Energy energy_of(const Particles& particles, const Vec3d& gravity, const Tait& tait);

}  // namespace sabo
