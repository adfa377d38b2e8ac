#include "backend/host_backend.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <omp.h>

#include "backend/host_loops.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/shear_state.hpp"

namespace sabo {
namespace {

using Index = std::ptrdiff_t;  // OpenMP loops want a signed index

}  // namespace

HostBackend::HostBackend(const FlowModel& model)
    : Backend(model),
      half_space_(model.h, model.dimension, model.spacing),
      yield_slope_(model.yield.slope()),
      threads_(model.threads > 0 ? model.threads : omp_get_max_threads()) {}

void HostBackend::find_neighbours() {
  if (model_.periodic.any())
    for (Vec3d& position : fluid_.position) position = model_.periodic.wrapped(position);
  list_pairs();
  list_bodies();
  settle_driven();
  list_driven_walls();
  const std::size_t all = fluid_.size() + boundary_.size();
  strain_.assign(all, {});
  stress_.assign(all, {});
  density_rate_.assign(all, 0);
  hold_walls();
  acceleration_.assign(fluid_.size(), {});
  pressure_power_.assign(fluid_.size(), 0);
  wall_share_.assign(fluid_.size(), {});
  wall_drag_.assign(fluid_.size(), 0);
  wall_slope_.assign(fluid_.size(), {});
  support_.assign(fluid_.size(), 0);
  filling_.assign(fluid_.size(), {});
  background_.assign(fluid_.size(), {});
  for (std::vector<double>* of_fluid :
       {&artificial_heat_, &diffusion_rate_, &heat_of_diffusion_, &heat_of_hold_})
    of_fluid->assign(fluid_.size(), 0);
}

void HostBackend::pressure() {
  const PassClock clock(pass_times_, "pressure");
  const Tait state = model_.state;
  for (Particles* particles : {&fluid_, &boundary_})
    over(particles->size(), threads_,
         [&](std::size_t i) { particles->pressure[i] = state.pressure(particles->density[i]); });
}

template <class Law>
void HostBackend::stress_of(const Law& law, Particles& particles, std::size_t offset,
                            bool carries_stress) {
  const double convention = model_.strain_convention();  // in the shear rate and in the stress
  over(particles.size(), threads_, [&](std::size_t i) {
    const Sym3<double>& eps = strain_[offset + i];
    const double p = particles.pressure[i];
    const double gd = convention * shear_rate(eps);
    const double mu = law.viscosity(shear_state<Law>(gd, p, model_.yield, yield_slope_));
    const double rho2 = particles.density[i] * particles.density[i];
    particles.shear_rate[i] = gd;
    particles.viscosity[i] = mu;
    stress_[offset + i] = isotropic(-p / rho2);
    if (carries_stress) stress_[offset + i] += (convention * mu / rho2) * eps;
  });
}

void HostBackend::stress() {
  const PassClock clock(pass_times_, "stress");
  const bool nested = model_.viscous_operator == ViscousOperator::nested;
  const bool wall = nested && model_.boundary_stress != BoundaryStress::none;
  std::visit(
      [&](const auto& law) {
        stress_of(law, fluid_, 0, nested);
        stress_of(law, boundary_, fluid_.size(), wall);
      },
      model_.rheology);
}

/// Sets the density of a boundary particle from fluid particles near it, if there are any.
void HostBackend::extrapolate_to(std::size_t b, const std::vector<std::uint32_t>& near) {
  const auto kernel = model_.kernel<double>();
  const Vec3d force = model_.body_force(boundary_.position[b]);
  double weight = 0;
  double pressure = 0;
  for (const std::uint32_t j : near) {
    const Vec3d x = model_.periodic.nearest(boundary_.position[b] - fluid_.position[j]);
    const double w = kernel.value(norm(x));
    weight += w;
    pressure += w * (fluid_.pressure[j] + fluid_.density[j] * dot(force, x));
  }
  if (weight > 0) boundary_.density[b] = model_.state.density(std::max(0.0, pressure / weight));
}

void HostBackend::extrapolate_to_boundary() {
  const PassClock clock(pass_times_, "start of the boundary");
  const Index walls = static_cast<Index>(boundary_.size());
#pragma omp parallel num_threads(threads_)
  {
    std::vector<std::uint32_t> near;
#pragma omp for schedule(static)
    for (Index b = 0; b < walls; ++b) {
      near.clear();
      fluid_near(fluid_.size() + static_cast<std::size_t>(b), near);
      extrapolate_to(static_cast<std::size_t>(b), near);
    }
  }
}

void HostBackend::add_central_force() {
  if (model_.central.strength == 0) return;
  over_rows(awake_, threads_, [&](std::size_t i) {
    acceleration_[i] -= model_.central.strength * (fluid_.position[i] - model_.central.origin);
  });
}

void HostBackend::hold_driven() {
  for (const std::uint32_t i : driven_) {
    acceleration_[i] = {};
    density_rate_[i] = 0;
  }
  hold_walls();
}

// A wall that follows continuity pushes away what comes near it until there is a gap. Driven
// particles do not give way: the wall under them would end up at a pressure that throws them up
// once they are free. It has their pressure instead.
void HostBackend::hold_walls() {
  std::vector<std::uint32_t> near;
  for (const std::uint32_t b : driven_walls_) {
    near.clear();
    fluid_near(fluid_.size() + b, near);
    const auto is_driven = [&](std::uint32_t j) {
      const Vec3d x = model_.periodic.nearest(boundary_.position[b] - fluid_.position[j]);
      return fluid_.driven[j] != 0 && norm(x) < model_.kernel_radius();
    };
    if (!std::ranges::any_of(near, is_driven)) continue;
    density_rate_[fluid_.size() + b] = 0;
    extrapolate_to(b, near);
  }
}

void HostBackend::list_driven_walls() {
  driven_walls_.clear();
  if (driven_.empty()) return;
  std::vector<std::uint32_t> near;
  for (std::uint32_t b = 0; b < boundary_.size(); ++b) {
    near.clear();
    fluid_near(fluid_.size() + b, near);
    const auto is_driven = [&](std::uint32_t j) { return fluid_.driven[j] != 0; };
    if (std::ranges::any_of(near, is_driven)) driven_walls_.push_back(b);
  }
}

FlowExtremes HostBackend::extremes() const {
  const PassClock clock(pass_times_, "checks and sums");
  double speed2 = 0;
  double acceleration2 = 0;
  double viscosity = 0;
  const Index awake = static_cast<Index>(awake_.size());
  const Index count = awake + static_cast<Index>(driven_.size());
#pragma omp parallel for num_threads(threads_) if (count > worth_threads) schedule(static) \
    reduction(max                                                                          \
              : speed2, acceleration2, viscosity)
  for (Index k = 0; k < count; ++k) {
    const std::size_t i = k < awake ? awake_[k] : driven_[k - awake];
    // A particle in free flight interacts with nobody: it must not set everybody's step.
    if (!has_neighbours_[i]) continue;
    speed2 = std::max(speed2, dot(fluid_.velocity[i], fluid_.velocity[i]));
    acceleration2 = std::max(acceleration2, dot(acceleration_[i], acceleration_[i]));
    viscosity = std::max(viscosity, fluid_.viscosity[i] / fluid_.density[i]);
  }
  return {std::sqrt(speed2), std::sqrt(acceleration2), viscosity};
}

FlowHealth HostBackend::health() const {
  const PassClock clock(pass_times_, "checks and sums");
  double lowest = model_.state.rho0;
  double highest = model_.state.rho0;
  bool is_finite = true;
  const Index count = static_cast<Index>(fluid_.size());
#pragma omp parallel for num_threads(threads_) if (count > worth_threads) schedule(static) \
    reduction(min : lowest) reduction(max : highest) reduction(&& : is_finite)
  for (Index i = 0; i < count; ++i) {
    const Vec3d& x = fluid_.position[i];
    const Vec3d& v = fluid_.velocity[i];
    is_finite = is_finite && std::isfinite(x.x + x.y + x.z + v.x + v.y + v.z + fluid_.density[i]);
    lowest = std::min(lowest, fluid_.density[i]);
    highest = std::max(highest, fluid_.density[i]);
  }
  return {lowest / model_.state.rho0, highest / model_.state.rho0, is_finite};
}

double HostBackend::dissipation() const {
  const PassClock clock(pass_times_, "checks and sums");
  // What the forces between particles take from the motion, less what pressure takes: viscosity
  // within the flow and at the walls, whatever the operator.
  return blocked_sum(fluid_.size(), threads_, [&](std::size_t i) -> double {
    if (fluid_.driven[i] != 0) return 0;
    const Vec3d between = acceleration_[i] - model_.body_force(fluid_.position[i]);
    const double power = dot(fluid_.velocity[i], between);
    return fluid_.mass[i] * (pressure_power_[i] - power);
  });
}

void HostBackend::predict(double dt) {
  const PassClock clock(pass_times_, "integration");
  start_position_ = fluid_.position;
  start_velocity_ = fluid_.velocity;
  start_density_ = fluid_.density;
  start_boundary_density_ = boundary_.density;
  const double half = 0.5 * dt;
  const double rho0 = model_.state.rho0;
  const std::size_t fluids = fluid_.size();
  over(fluids, threads_, [&](std::size_t i) {
    fluid_.position[i] += half * fluid_.velocity[i];
    fluid_.velocity[i] += half * acceleration_[i];
    fluid_.density[i] += half * density_rate_[i];
  });
  over(boundary_.size(), threads_, [&](std::size_t i) {
    boundary_.density[i] = std::max(rho0, boundary_.density[i] + half * density_rate_[fluids + i]);
  });
}

void HostBackend::correct(double dt) {
  const PassClock clock(pass_times_, "integration");
  const double rho0 = model_.state.rho0;
  // rho(n+1) = rho(n) (2 + k) / (2 - k), k = dt (drho/dt) / rho at the middle: the implicit
  // midpoint of d(ln rho)/dt, which keeps rho positive (Parshikov et al. 2000).
  const auto advanced = [dt](double start, double middle, double rate) {
    const double k = dt * rate / middle;
    return start * (2 + k) / (2 - k);
  };
  const std::size_t fluids = fluid_.size();
  over(fluids, threads_, [&](std::size_t i) {
    const Vec3d velocity = start_velocity_[i] + dt * acceleration_[i];
    fluid_.position[i] = start_position_[i] + (0.5 * dt) * (start_velocity_[i] + velocity);
    fluid_.velocity[i] = velocity;
    fluid_.density[i] = advanced(start_density_[i], fluid_.density[i], density_rate_[i]);
  });
  // A wall that remembers suction would hold the flow back: boundary density stays at or above
  // its reference (as in dynamic boundary codes since Crespo et al. 2007).
  over(boundary_.size(), threads_, [&](std::size_t i) {
    boundary_.density[i] = std::max(rho0, advanced(start_boundary_density_[i], boundary_.density[i],
                                                   density_rate_[fluids + i]));
  });
}

}  // namespace sabo
