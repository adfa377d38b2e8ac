#include <algorithm>
#include <cmath>

#include <omp.h>

#include "backend/host_backend.hpp"
#include "physics/pair/forces.hpp"

// What the fluid does to bodies: minus what the pairs with their particles do to the fluid. Summed
// by the particles of the bodies, which are few, so that the sweeps over the fluid know nothing of
// it; a force acts at the particle of the body.

namespace sabo {

void HostBackend::list_bodies() {
  body_forces_.clear();
  std::size_t bodies = body_loads_.size();
  for (std::size_t b = 0; b < boundary_.size(); ++b) {
    if (boundary_.body[b] == 0) continue;
    body_forces_.push_back({static_cast<std::uint32_t>(b), {}});
    bodies = std::max<std::size_t>(bodies, boundary_.body[b]);
  }
  body_loads_.resize(bodies);
  row_forces_.resize(body_forces_.size());
}

void HostBackend::unload_bodies() {
  std::ranges::fill(body_loads_, BodyLoad{});
  for (BodyForce& at : body_forces_) at.force = {};
}

/// Adds force(i, b, pair) on boundary particle b by each fluid particle i near it, N.
template <class PairForce>
void HostBackend::add_to_bodies(const PairForce& force) {
  const PassClock clock(pass_times_, "bodies");
  const auto kernel = model_.kernel<double>();
  near_rows_.resize(static_cast<std::size_t>(threads_));
  const auto count = static_cast<std::ptrdiff_t>(body_forces_.size());
#pragma omp parallel num_threads(threads_) if (count > 256)
  {
    std::vector<std::uint32_t>& near = near_rows_[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
      const std::size_t b = body_forces_[k].particle;
      near.clear();
      fluid_near(fluid_.size() + b, near);
      Vec3d sum;
      for (const std::uint32_t i : near) {
        const Vec3d x = model_.periodic.nearest(fluid_.position[i] - boundary_.position[b]);
        sum += force(i, b, pair_geometry(x, kernel));
      }
      row_forces_[k] = sum;
    }
  }
  // In the order of the particles, whichever thread summed which.
  for (std::size_t k = 0; k < body_forces_.size(); ++k) {
    const std::size_t b = body_forces_[k].particle;
    body_forces_[k].force += row_forces_[k];
    body_loads_[boundary_.body[b] - 1u] +=
        BodyLoad{row_forces_[k], cross(boundary_.position[b], row_forces_[k])};
  }
}

/// Artificial viscosity between fluid i and boundary b, on i, m/s2.
Vec3d HostBackend::artificial_on_wall(std::size_t i, std::size_t b,
                                      const PairGeometry<double>& pair) const {
  const double alpha_c0_h = model_.artificial_viscosity * model_.state.c0 * model_.h;
  const double mean_density = 0.5 * (fluid_.density[i] + boundary_.density[b]);
  return artificial_viscosity(pair, fluid_.velocity[i] - boundary_.velocity[b], alpha_c0_h,
                              boundary_.mass[b] / mean_density, model_.eta2())
      .acceleration;
}

void HostBackend::load_bodies_by_stress() {
  if (body_loads_.empty()) return;
  unload_bodies();
  const bool morris = model_.viscous_operator == ViscousOperator::morris;
  const double factor = model_.strain_convention() * model_.wall_velocity_factor();
  add_to_bodies([&](std::size_t i, std::size_t b, const PairGeometry<double>& pair) {
    const double mass = boundary_.mass[b];
    Vec3d a = stress_force(pair, stress_[i], stress_[fluid_.size() + b], mass);
    if (morris)
      a += morris_force(pair, fluid_.velocity[i] - boundary_.velocity[b],
                        factor * fluid_.viscosity[i],
                        mass / (fluid_.density[i] * boundary_.density[b]), model_.eta2());
    return -fluid_.mass[i] * (a + artificial_on_wall(i, b, pair));
  });
}

void HostBackend::load_bodies_by_pressure() {
  if (body_loads_.empty()) return;
  unload_bodies();
  const double per_rho2 = 1 / (model_.state.rho0 * model_.state.rho0);
  add_to_bodies([&](std::size_t i, std::size_t b, const PairGeometry<double>& pair) {
    const Vec3d a = pressure_force(pair, per_rho2 * fluid_.pressure[i],
                                   per_rho2 * boundary_.pressure[b], boundary_.mass[b]);
    return -fluid_.mass[i] * a;
  });
}

/// With the new velocities. What holds a particle is shared out among the boundary particles by
/// which it knows of the wall, as its share of the wall is.
void HostBackend::load_bodies_by_friction() {
  if (body_loads_.empty()) return;
  const auto kernel = model_.kernel<double>();
  add_to_bodies([&](std::size_t i, std::size_t b, const PairGeometry<double>& pair) {
    const WallShare& wall = wall_share_[i];
    if (!(wall_drag_[i] > 0)) return Vec3d{};
    const double part =
        boundary_.mass[b] / model_.state.rho0 * kernel.value(std::sqrt(pair.r2)) / wall.share;
    return part * wall_drag_[i] * (fluid_.velocity[i] - (1 / wall.share) * wall.velocity);
  });
}

}  // namespace sabo
