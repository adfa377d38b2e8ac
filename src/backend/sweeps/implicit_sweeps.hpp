#pragma once

#include <algorithm>
#include <cmath>

#include "backend/flow_view.hpp"
#include "backend/sweeps/explicit_sweeps.hpp"
#include "backend/sweeps/sleep.hpp"
#include "backend/sweeps/tension.hpp"

// What the implicit method does at one particle at a time.

namespace sabo {

/// Resistance of the wall, by its law, to a particle whose share of the wall is known.
template <class Law, class WallLaw>
struct FindWallResistance {
  FlowView flow;
  Law law;
  WallLaw wall_law;

  SABO_HD void operator()(std::size_t i) const {
    const WallShare& wall = flow.wall[i];
    flow.wall_drag[i] = 0;
    flow.grip[i] = {};
    // A particle whose kernel barely touches the wall has no direction to it.
    if (!(wall.share > 1e-6) || !(norm(wall.gradient) > 0)) return;
    const double nearest = 0.25 * flow.model.spacing;
    const double steepness = norm(wall.gradient);
    const Vec3d normal = (-1 / steepness) * wall.gradient;
    const double distance = larger(flow.half_space->distance(wall.share), nearest);
    // The areas 2 V |grad S| of all particles add up to that of the wall, since the integral of
    // |dS/dd| over the distance is 1/2.
    const double area = 2 * flow.fluid.mass[i] / flow.model.state.rho0 * steepness;
    const WallContact at = contact(i, normal, distance);
    const double resistance = wall_law.resistance(at);
    flow.wall_drag[i] = area * resistance;
    flow.grip[i] = {(1 / distance) * normal, at.sticking > 0 ? resistance / at.sticking : 0};
  }

 private:
  /// Everything a wall law needs of the flow.
  SABO_HD WallContact contact(std::size_t i, const Vec3d& normal, double distance) const {
    const FlowModel& model = flow.model;
    const WallShare& wall = flow.wall[i];
    const Vec3d relative = flow.fluid.velocity[i] - (1 / wall.share) * wall.velocity;
    const Vec3d slip = along(relative, normal);

    WallContact at;
    at.speed = norm(slip);
    at.density = flow.fluid.density[i];
    const Vec3d force = model.body_force(flow.fluid.position[i]);
    at.gravity = norm(force);
    const double pressure = flow.fluid.pressure[i] - at.density * distance * dot(force, normal);
    at.pressure = model.yield.effective_pressure(pressure);
    const double convention = model.strain_convention();
    // With its part across the wall: without it a particle that pressure drives straight out of the
    // wall would be held by the viscosity at rest, that is by more than its yield stress.
    const double rate = convention * norm(relative) / distance;
    const double halfway = 0.5 * (flow.fluid.pressure[i] + pressure);
    const Shear shear = shear_state<Law>(rate, halfway, model.yield, flow.yield_slope);
    // u/d is the shear rate halfway to the wall. What the friction of the last step takes from the
    // fluid between there and the wall, rho f d/2, comes on top, whatever the law of flow.
    const double halfway_sticking = convention * law.viscosity(shear) / distance;
    const double taken = -dot(flow.fluid.drag[i], slip);
    const double more =
        at.speed > 0 ? 0.5 * at.density * distance * taken / (at.speed * at.speed) : 0;
    at.sticking =
        halfway_sticking + std::clamp(more, -0.5 * halfway_sticking, 0.5 * halfway_sticking);
    return at;
  }
};

/// Fourtakas et al. 2019 leave the gradient of a fluid at rest alone, rho0 g / c^2. It takes the c
/// of the density at the place: with c0 the floor under a column came to carry 1 % too much. A
/// layer on a slope is not at rest under its weight alone: friction carries the part along the
/// slope, which leaves no density gradient there. At most that of a fluid at rest, whatever an
/// impact does.
struct FindDiffusionBackground {
  FlowView flow;
  SABO_HD void operator()(std::size_t i) const {
    const double c = flow.model.state.sound_speed(flow.fluid.density[i]);
    const double per_c2 = 1 / (c * c);
    const Vec3d force = flow.model.body_force(flow.fluid.position[i]);
    const double most = norm(force);
    const Vec3d carried = force + flow.fluid.drag[i];
    const double size = norm(carried);
    flow.background[i] = (size > most ? per_c2 * most / size : per_c2) * carried;
  }
};

/// Density by continuity (Eq. 7) knows what the flow did, not where the particles are. Where a
/// thick mass spreads, particles from its inside come to its surface; the empty part of their
/// kernel counts as expansion, density diffusion makes up for it with density from inside, and over
/// time a deposit crowds at the density of rest, or particles sink into the ground. So density is
/// held to the places of the particles: to their number in the kernel, the kernel completed above a
/// free surface, where the two differ by more than disorder explains. A place that is too empty
/// only takes pressure away, it does not pull.
SABO_HD inline double held_to_places(const FlowView& flow, double density, std::size_t i,
                                     double borne, double catch_up) {
  const Filling& filling = flow.filling[i];
  const double rho0 = flow.model.state.rho0;
  const double slack = flow.model.crowding_tolerance * rho0;
  const double placed =
      rho0 * filling.share * flow.half_space->completion(norm(filling.gradient) / filling.share);
  // A fluid that tears does not remember by how much, and up to rho0, where it does not press, it
  // need not catch up: in two streams that pass each other its density would fall all the time.
  const double torn = 1 - borne;
  const double least = placed + torn * larger(rho0 - placed, 0.0) - slack;
  density += torn * larger(smaller(least, rho0) - density, 0.0);
  if (density < least) return density + catch_up * (least - density);
  const double most = larger(rho0, placed + slack);
  return density > most ? density + catch_up * (most - density) : density;
}

/// What the scheme takes from the energy of the flow over a step, J.
struct StepHeat {
  double artificial = 0, diffusion = 0, hold = 0, shifting = 0, walls = 0;
  SABO_HD void join(const StepHeat& other) {
    artificial += other.artificial;
    diffusion += other.diffusion;
    hold += other.hold;
    shifting += other.shifting;
    walls += other.walls;
  }
  SABO_HD void enter(HeatAccount& account) const {
    account.numerical.artificial_viscosity += artificial;
    account.numerical.density_diffusion += diffusion;
    account.numerical.density_hold += hold;
    account.numerical.shifting += shifting;
    account.numerical.walls += walls;
  }
};

/// Density, place and pressure at the end of the step.
struct AdvanceState {
  static constexpr double crowding_time = 3;  ///< smoothing lengths over the speed of sound

  FlowView flow;
  const std::uint32_t* rows;
  double dt;
  double catch_up;  ///< share of a density gap that the step closes

  static double caught_up(const FlowModel& model, double dt) {
    return -std::expm1(-dt * model.state.c0 / (crowding_time * model.h));
  }

  SABO_HD void operator()(std::size_t k, StepHeat& sum) const {
    const std::size_t i = rows[k];
    const ParticleView& fluid = flow.fluid;
    const Tait& state = flow.model.state;
    const double before = fluid.density[i];
    const double moved = advanced_density(before, before, flow.density_rate[i], dt);
    const double borne = borne_tension(flow.model, flow.support[i]);
    // Nothing presses on a particle by itself.
    const double held =
        flow.has_neighbours[i] ? held_to_places(flow, moved, i, borne, catch_up) : state.rho0;
    fluid.density[i] = held;
    const double mass = fluid.mass[i];
    const double artificial = flow.model.artificial_viscosity > 0 ? flow.artificial_heat[i] : 0;
    sum.artificial += mass * dt * artificial;
    const double per_density = borne_mean(state, before, moved, borne);
    sum.diffusion -= mass * per_density * dt * flow.diffusion_rate[i];
    // Between two particles of the fluid the work of pressure is found again as compression, but
    // for what changes over a step: in the sum over all, what is missing went to the walls.
    const Vec3d force = flow.model.body_force(fluid.position[i]);
    const Vec3d velocity =  // mean of the step, as for the heat of viscosity
        fluid.velocity[i] - 0.5 * dt * (flow.acceleration[i] + fluid.drag[i]);
    const double pushed = dot(velocity, flow.acceleration[i] - force) + artificial;
    double compressed = dt * per_density * (flow.density_rate[i] - flow.diffusion_rate[i]);
    if (flow.model.particle_shifting > 0 && dt > 0) {
      const Shift& shift = flow.shift[i];
      const double filled = per_density * state.rho0 * shift.filled;  // a part of the density rate
      sum.shifting += mass * (dot(force, shift.by) - filled);
      compressed -= filled;
    }
    sum.walls -= mass * (dt * pushed + compressed);
    sum.hold += mass * (borne_energy(state, moved, borne) - borne_energy(state, held, borne));
    if (!flow.model.tension_at_surface)  // what tears lets go of what it stored, or takes it up
      sum.hold +=
          mass * (state.borne_share(before, fluid.pressure[i]) * state.elastic_energy(before) -
                  borne_energy(state, before, borne));
    fluid.position[i] += dt * fluid.velocity[i];
    fluid.calm[i] = is_calm(flow, i) ? smaller(fluid.calm[i] + dt, flow.model.sleep.time) : 0;
    fluid.pressure[i] = borne_pressure(state, fluid.density[i], borne);
  }
};

/// Shear rate and effective viscosity of the fluid from its strain rate and pressure.
template <class Law>
struct FindViscosity {
  FlowView flow;
  Law law;
  SABO_HD void operator()(std::size_t i) const {
    const double gd = flow.model.strain_convention() * shear_rate(flow.strain[i]);
    flow.fluid.shear_rate[i] = gd;
    flow.fluid.viscosity[i] = law.viscosity(
        shear_state<Law>(gd, flow.fluid.pressure[i], flow.model.yield, flow.yield_slope));
  }
};

}  // namespace sabo
