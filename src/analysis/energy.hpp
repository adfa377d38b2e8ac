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

  Energy& operator+=(const Energy& other) {
    mass += other.mass;
    kinetic += other.kinetic;
    potential += other.potential;
    elastic += other.elastic;
    return *this;
  }
  friend Energy operator+(Energy a, const Energy& b) { return a += b; }
  void join(const Energy& other) { *this += other; }
};

/// Sums over the rows in fixed blocks. `gravity` in m/s2. A fluid that may be torn, that of a model
/// without tension_at_surface, stores the share of its tension that it bears.
Energy energy_of(const Particles& particles, const Vec3d& gravity, const Tait& tait,
                 bool may_be_torn = false);

/// Where the potential energy that a flow has given up went, J.
struct EnergyBalance {
  double released = 0;     ///< potential energy at the start less that now, and of what left
  double kinetic = 0;      ///< now
  double dissipated = 0;   ///< by viscosity and the ground
  double numerical = 0;    ///< taken by the scheme itself
  double carried_off = 0;  ///< motion and compression of what left
  double unaccounted = 0;  ///< found now in all, less what there was; negative when some is missing

  /// Of what was released; 0 when nothing moved.
  double share(double energy) const { return released > 0 ? energy / released : 0; }
  double imbalance() const { return share(unaccounted); }
};

/// `start` is what there was and what has come in since, each at the time it did.
EnergyBalance energy_balance(const Energy& start, const Energy& now, const Energy& left,
                             double dissipated, double numerical);

/// Energy that a flow has beyond what it started with, as if all of it had fallen so many metres
/// more than it has; what it has lost makes it negative. `gravity` in m/s2.
double surplus_fall(const Energy& start, const Energy& now, const Energy& left, double gravity);

/// Work of what pushes particles through an inflow, the sum of p m/rho, J.
double push_behind(const Particles& particles, const Tait& tait);

}  // namespace sabo
