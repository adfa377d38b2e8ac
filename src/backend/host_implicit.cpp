#include <algorithm>
#include <cmath>
#include <variant>

#include "backend/host_backend.hpp"
#include "backend/host_loops.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/shear_state.hpp"

// The sweeps of the implicit method that look at one particle at a time.

namespace sabo {
namespace {

constexpr double crowding_time = 3;  // smoothing lengths over the speed of sound

}  // namespace

/// Everything a wall law needs of the flow at particle i, whose share of the wall is known.
template <class Law>
WallContact HostBackend::contact_of(const Law& law, std::size_t i, const Vec3d& normal,
                                    double distance) const {
  const WallShare& wall = wall_share_[i];
  const Vec3d relative = fluid_.velocity[i] - (1 / wall.share) * wall.velocity;
  const Vec3d slip = along(relative, normal);

  WallContact at;
  at.speed = norm(slip);
  at.density = fluid_.density[i];
  const Vec3d force = model_.body_force(fluid_.position[i]);
  at.gravity = norm(force);
  const double pressure = fluid_.pressure[i] - at.density * distance * dot(force, normal);
  at.pressure = model_.yield.effective_pressure(pressure);
  const double convention = model_.strain_convention();
  // With its part across the wall: without it a particle that pressure drives straight out of the
  // wall would be held by the viscosity at rest, that is by more than its yield stress.
  const double rate = convention * norm(relative) / distance;
  const double halfway = 0.5 * (fluid_.pressure[i] + pressure);
  const Shear shear = shear_state<Law>(rate, halfway, model_.yield, yield_slope_);
  // u/d is the shear rate halfway to the wall. What the friction of the last step takes from the
  // fluid between there and the wall, rho f d/2, comes on top, whatever the law of flow.
  const double halfway_sticking = convention * law.viscosity(shear) / distance;
  const double taken = -dot(fluid_.drag[i], slip);
  const double more =
      at.speed > 0 ? 0.5 * at.density * distance * taken / (at.speed * at.speed) : 0;
  at.sticking =
      halfway_sticking + std::clamp(more, -0.5 * halfway_sticking, 0.5 * halfway_sticking);
  return at;
}

void HostBackend::wall_resistance() {
  const PassClock clock(pass_times_, "wall law");
  const double nearest = 0.25 * model_.spacing;
  const auto with = [&](const auto& law, const auto& wall_law) {
    over_rows(awake_, threads_, [&](std::size_t i) {
      const WallShare& wall = wall_share_[i];
      wall_drag_[i] = 0;
      wall_slope_[i] = {};
      // A particle whose kernel barely touches the wall has no direction to it.
      if (!(wall.share > 1e-6) || !(norm(wall.gradient) > 0)) return;
      const double steepness = norm(wall.gradient);
      const Vec3d normal = (-1 / steepness) * wall.gradient;
      const double distance = std::max(half_space_.distance(wall.share), nearest);
      // The areas 2 V |grad S| of all particles add up to that of the wall, since the integral of
      // |dS/dd| over the distance is 1/2.
      const double area = 2 * fluid_.mass[i] / model_.state.rho0 * steepness;
      wall_drag_[i] = area * wall_law.resistance(contact_of(law, i, normal, distance));
      wall_slope_[i] = (1 / distance) * normal;
    });
  };
  std::visit(with, model_.rheology, model_.wall);
}

// Fourtakas et al. 2019 leave the gradient of a fluid at rest alone, rho0 g / c^2. It takes the c
// of the density at the place: with c0 the floor under a column came to carry 1 % too much. A layer
// on a slope is not at rest under its weight alone: friction carries the part along the slope,
// which leaves no density gradient there. At most that of a fluid at rest, whatever an impact does.
void HostBackend::find_diffusion_background() {
  if (model_.diffusion_form != DiffusionForm::fourtakas) return;
  const Tait state = model_.state;
  over_rows(awake_, threads_, [&](std::size_t i) {
    const double c = state.sound_speed(fluid_.density[i]);
    const double per_c2 = 1 / (c * c);
    const Vec3d force = model_.body_force(fluid_.position[i]);
    const double most = norm(force);
    const Vec3d carried = force + fluid_.drag[i];
    const double size = norm(carried);
    background_[i] = (size > most ? per_c2 * most / size : per_c2) * carried;
  });
}

// Density by continuity (Eq. 7) knows what the flow did, not where the particles are. Where a thick
// mass spreads, particles from its inside come to its surface; the empty part of their kernel
// counts as expansion, density diffusion makes up for it with density from inside, and over time a
// deposit crowds at the density of rest, or particles sink into the ground. So density is held to
// the places of the particles: to their number in the kernel, the kernel completed above a free
// surface, where the two differ by more than disorder explains. A place that is too empty only
// takes pressure away, it does not pull.
double HostBackend::held_to_places(double density, std::size_t i, double catch_up) const {
  const Filling& filling = filling_[i];
  const double rho0 = model_.state.rho0;
  const double slack = model_.crowding_tolerance * rho0;
  const double placed =
      rho0 * filling.share * half_space_.completion(norm(filling.gradient) / filling.share);
  if (density < placed - slack) return density + catch_up * (placed - slack - density);
  const double most = std::max(rho0, placed + slack);
  return density > most ? density + catch_up * (most - density) : density;
}

void HostBackend::advance_state(double dt) {
  if (model_.particle_shifting > 0) shift_particles(dt);
  const PassClock clock(pass_times_, "density and viscosity");
  const double rho0 = model_.state.rho0;
  const Tait state = model_.state;
  const double catch_up = -std::expm1(-dt * state.c0 / (crowding_time * model_.h));
  const auto sum_over_awake = [&](const auto& f) {
    return blocked_sum(awake_.size(), threads_, [&](std::size_t k) { return f(awake_[k]); });
  };
  if (model_.artificial_viscosity > 0)
    numerical_heat_.artificial_viscosity +=
        dt * sum_over_awake([&](std::size_t i) { return fluid_.mass[i] * artificial_heat_[i]; });
  over_rows(awake_, threads_, [&](std::size_t i) {
    // d(ln rho)/dt over the step, as in correct().
    const double before = fluid_.density[i];
    const double k = dt * density_rate_[i] / before;
    const double moved = before * (2 + k) / (2 - k);
    // Nothing presses on a particle by itself.
    const double held = has_neighbours_[i] ? held_to_places(moved, i, catch_up) : rho0;
    fluid_.density[i] = held;
    const double mean = 0.5 * (before + moved);
    const double mass = fluid_.mass[i];
    heat_of_diffusion_[i] = -mass * state.pressure(mean) / (mean * mean) * dt * diffusion_rate_[i];
    heat_of_hold_[i] = mass * (state.elastic_energy(moved) - state.elastic_energy(held));
    fluid_.position[i] += dt * fluid_.velocity[i];
    fluid_.calm[i] = is_calm(i) ? fluid_.calm[i] + dt : 0;
    fluid_.pressure[i] = state.pressure(fluid_.density[i]);
  });
  over_rows(driven_, threads_,
            [&](std::size_t i) { fluid_.position[i] += dt * fluid_.velocity[i]; });
  numerical_heat_.density_diffusion +=
      sum_over_awake([&](std::size_t i) { return heat_of_diffusion_[i]; });
  numerical_heat_.density_hold += sum_over_awake([&](std::size_t i) { return heat_of_hold_[i]; });
  find_viscosity();
}

void HostBackend::find_viscosity() {
  const double convention = model_.strain_convention();
  std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        over_rows(awake_, threads_, [&](std::size_t i) {
          const double gd = convention * shear_rate(strain_[i]);
          fluid_.shear_rate[i] = gd;
          fluid_.viscosity[i] =
              law.viscosity(shear_state<Law>(gd, fluid_.pressure[i], model_.yield, yield_slope_));
        });
      },
      model_.rheology);
}

void HostBackend::settle_driven() {
  const auto settle = [&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    over_rows(driven_, threads_, [&](std::size_t i) {
      const double p = model_.state.pressure(fluid_.density[i]);
      const double gd = model_.strain_convention() * fluid_.shear_rate[i];
      fluid_.pressure[i] = p;
      fluid_.viscosity[i] = law.viscosity(shear_state<Law>(gd, p, model_.yield, yield_slope_));
    });
  };
  std::visit(settle, model_.rheology);
}

void HostBackend::set_sound_speed(double c0) {
  const Tait former = model_.state;
  model_.state.c0 = c0;
  const Tait state = model_.state;
  numerical_heat_.sound_speed += blocked_sum(fluid_.size(), threads_, [&](std::size_t i) {
    const double before = former.elastic_energy(fluid_.density[i]);
    fluid_.density[i] = state.density(fluid_.pressure[i]);
    return fluid_.mass[i] * (before - state.elastic_energy(fluid_.density[i]));
  });
}

}  // namespace sabo
