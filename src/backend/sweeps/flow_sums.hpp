#pragma once

#include <cmath>

#include "backend/flow_view.hpp"
#include "backend/heat_account.hpp"
#include "math/scalar.hpp"
#include "physics/time_step.hpp"

// Sums and extremes over particles: f(k, sum) adds the k-th, join() adds what others have summed.
// Comparisons are such that a NaN is no extreme.

namespace sabo {

struct Total {
  double value = 0;
  SABO_HD void join(const Total& other) { value += other.value; }
};

/// Squares of the fastest; without those in free flight, which interact with nobody and must not
/// set everybody's step.
struct Fastest {
  double speed2 = 0, acceleration2 = 0, viscosity = 0;
  SABO_HD void join(const Fastest& other) {
    speed2 = larger(other.speed2, speed2);
    acceleration2 = larger(other.acceleration2, acceleration2);
    viscosity = larger(other.viscosity, viscosity);
  }
  FlowExtremes extremes() const { return {std::sqrt(speed2), std::sqrt(acceleration2), viscosity}; }
};
struct FindFastest {
  const std::uint32_t* rows;
  const char* has_neighbours;
  const Vec3d* velocity;
  const Vec3d* acceleration;
  const double* viscosity;
  const double* density;
  SABO_HD void operator()(std::size_t k, Fastest& sum) const {
    const std::size_t i = rows[k];
    if (!has_neighbours[i]) return;
    sum.join({dot(velocity[i], velocity[i]), dot(acceleration[i], acceleration[i]),
              viscosity[i] / density[i]});
  }
};

/// Extremes of the ratio of density to its reference, and how many particles are not finite.
struct Condition {
  double lowest = 1, highest = 1;  // a flow without particles is healthy
  double broken = 0;
  SABO_HD void join(const Condition& other) {
    lowest = smaller(other.lowest, lowest);
    highest = larger(other.highest, highest);
    broken += other.broken;
  }
};
struct FindCondition {
  const Vec3d* position;
  const Vec3d* velocity;
  const double* density;
  double rho0;
  SABO_HD void operator()(std::size_t i, Condition& sum) const {
    const Vec3d& x = position[i];
    const Vec3d& v = velocity[i];
    const double all = x.x + x.y + x.z + v.x + v.y + v.z + density[i];
    const double ratio = density[i] / rho0;
    sum.join({ratio, ratio, std::isfinite(all) ? 0.0 : 1.0});
  }
};

/// What the forces between particles take from the motion, less what pressure takes: viscosity
/// within the flow and at the walls, whatever the operator; none of driven particles. W.
struct FindDissipation {
  FlowModel model;
  const Vec3d* position;
  const Vec3d* velocity;
  const Vec3d* acceleration;
  const double* mass;
  const std::uint16_t* driven;
  const double* pressure_power;
  SABO_HD void operator()(std::size_t i, Total& sum) const {
    if (driven[i] != 0) return;
    const Vec3d between = acceleration[i] - model.body_force(position[i]);
    sum.value += mass[i] * (pressure_power[i] - dot(velocity[i], between));
  }
};

/// Of the explicit method: what density diffusion and pressure between flow and walls take from
/// motion and compression; none of driven particles. W.
struct ExplicitHeat {
  double diffusion = 0, walls = 0;
  SABO_HD void join(const ExplicitHeat& other) {
    diffusion += other.diffusion;
    walls += other.walls;
  }
  SABO_HD void enter(double dt, HeatAccount& account) const {
    account.numerical.density_diffusion += dt * diffusion;
    account.numerical.walls += dt * walls;
  }
};
struct FindExplicitHeat {
  FlowView flow;
  SABO_HD void operator()(std::size_t i, ExplicitHeat& sum) const {
    const ParticleView& fluid = flow.fluid;
    if (fluid.driven[i] != 0) return;
    const double density = fluid.density[i];
    sum.diffusion -=
        fluid.mass[i] * fluid.pressure[i] / (density * density) * flow.diffusion_rate[i];
    sum.walls += fluid.mass[i] * flow.wall_heat[i];
  }
};

/// Energy that another speed of sound takes, J.
struct SoundHeat {
  double value = 0;
  SABO_HD void join(const SoundHeat& other) { value += other.value; }
  SABO_HD void enter(double /*dt*/, HeatAccount& account) const {
    account.numerical.sound_speed += value;
  }
};

/// Densities for another speed of sound.
struct ChangeSoundSpeed {
  Tait former, state;
  ParticleView fluid;
  bool may_be_torn;  ///< then the pressure of a particle may not be that of its density
  SABO_HD void operator()(std::size_t i, SoundHeat& sum) const {
    double& density = fluid.density[i];
    const double before = former.elastic_energy(density);
    const double pressure = may_be_torn ? former.pressure(density) : fluid.pressure[i];
    const double borne = may_be_torn ? former.borne_share(density, fluid.pressure[i]) : 1;
    density = state.density(pressure);
    if (fluid.driven[i] != 0) return;  // counts as what it brings, once it is free
    sum.value += fluid.mass[i] * borne * (before - state.elastic_energy(density));
  }
};

}  // namespace sabo
