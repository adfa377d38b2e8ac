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

  friend Energy operator+(const Energy& a, const Energy& b) {
    return {a.mass + b.mass, a.kinetic + b.kinetic, a.potential + b.potential,
            a.elastic + b.elastic};
  }
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

/// Where the potential energy that a flow has given up went, J.
struct EnergyBalance {
  double released = 0;     ///< potential energy at the start less that now, and of what left
  double kinetic = 0;      ///< now
  double dissipated = 0;   ///< by viscosity and the ground
  double carried_off = 0;  ///< motion and compression of what left
  double unaccounted = 0;  ///< found now in all, less what there was; negative when some is missing

  /// Over what was released; 0 when nothing moved.
  double imbalance() const { return released > 0 ? unaccounted / released : 0; }
};

EnergyBalance energy_balance(const Energy& start, const Energy& now, const Energy& left,
                             double dissipated);

}  // namespace sabo
