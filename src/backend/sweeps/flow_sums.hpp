#pragma once

#include <cmath>

#include "backend/chosen_step.hpp"
#include "backend/flow_view.hpp"
#include "backend/heat_account.hpp"
#include "math/scalar.hpp"

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
  SABO_HD FlowExtremes extremes() const {
    return {std::sqrt(speed2), std::sqrt(acceleration2), viscosity};
  }
};
/// Over the particles of two lists, those of the second counting from the last of the first.
struct FindFastest {
  RowList awake, driven;
  const char* has_neighbours;
  const Vec3d* velocity;
  const Vec3d* acceleration;
  const double* viscosity;
  const double* density;
  SABO_HD void operator()(std::size_t k, Fastest& sum) const {
    const std::size_t i = k < awake.count ? awake.index[k] : driven.index[k - awake.count];
    if (!has_neighbours[i]) return;
    sum.join({dot(velocity[i], velocity[i]), dot(acceleration[i], acceleration[i]),
              viscosity[i] / density[i]});
  }
};

template <class Rule>
struct ChooseStep {
  Rule rule;
  double longest;  ///< that it may be, s
  ChosenStep* step;
  SABO_HD void operator()(const Fastest& fastest) const {
    const FlowExtremes flow = fastest.extremes();
    *step = {flow, smaller(longest, rule.longest(flow))};
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

/// Of the explicit method, over a step: what viscosity, density diffusion and pressure between flow
/// and walls take from motion and compression; none of driven particles. J.
struct ExplicitHeat {
  double viscosity = 0, diffusion = 0, walls = 0;
  SABO_HD void join(const ExplicitHeat& other) {
    viscosity += other.viscosity;
    diffusion += other.diffusion;
    walls += other.walls;
  }
  SABO_HD void enter(HeatAccount& account) const {
    account.viscosity += viscosity;
    account.numerical.density_diffusion += diffusion;
    account.numerical.walls += walls;
  }
};
struct FindExplicitHeat {
  FlowView flow;
  const ChosenStep* step;
  SABO_HD void operator()(std::size_t i, ExplicitHeat& sum) const {
    const ParticleView& fluid = flow.fluid;
    if (fluid.driven[i] != 0) return;
    // What the forces between particles take from the motion, less what pressure takes: viscosity
    // within the flow and at the walls, whatever the operator; with moving walls their work too.
    const Vec3d between = flow.acceleration[i] - flow.model.body_force(fluid.position[i]);
    const double by_viscosity = flow.pressure_power[i] - dot(fluid.velocity[i], between);
    const double density = fluid.density[i];
    const double mass = step->dt * fluid.mass[i];
    sum.viscosity += mass * by_viscosity;
    sum.diffusion -= mass * fluid.pressure[i] / (density * density) * flow.diffusion_rate[i];
    sum.walls += mass * flow.wall_heat[i];
  }
};

/// Energy that another speed of sound takes, J.
struct SoundHeat {
  double value = 0;
  SABO_HD void join(const SoundHeat& other) { value += other.value; }
  SABO_HD void enter(HeatAccount& account) const { account.numerical.sound_speed += value; }
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
