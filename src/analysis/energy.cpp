#include "analysis/energy.hpp"

#include "base/host_loops.hpp"

namespace sabo {

Energy energy_of(const Particles& particles, const Vec3d& gravity, const Tait& tait,
                 bool may_be_torn) {
  return blocked_sum<Energy>(particles.size(), 1, [&](std::size_t i, Energy& sum) {
    const double mass = particles.mass[i];
    const Vec3d& velocity = particles.velocity[i];
    const double density = particles.density[i];
    const double borne = may_be_torn ? tait.borne_share(density, particles.pressure[i]) : 1;
    sum += {mass, 0.5 * mass * dot(velocity, velocity), -mass * dot(gravity, particles.position[i]),
            mass * borne * tait.elastic_energy(density)};
  });
}

double push_behind(const Particles& particles, const Tait& tait) {
  double work = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    work += particles.mass[i] / particles.density[i] * tait.pressure(particles.density[i]);
  return work;
}

double surplus_fall(const Energy& start, const Energy& now, const Energy& left, double gravity) {
  const double weight = start.mass * gravity;
  return weight > 0 ? (now.total() + left.total() - start.total()) / weight : 0;
}

EnergyBalance energy_balance(const Energy& start, const Energy& now, const Energy& left,
                             double dissipated, double numerical) {
  EnergyBalance balance;
  balance.released = start.potential - now.potential - left.potential;
  balance.kinetic = now.kinetic;
  balance.dissipated = dissipated;
  balance.numerical = numerical;
  balance.carried_off = left.kinetic + left.elastic;
  balance.unaccounted = now.total() + left.total() + dissipated + numerical - start.total();
  return balance;
}

}  // namespace sabo
