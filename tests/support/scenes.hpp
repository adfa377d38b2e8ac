#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "backend/backend.hpp"
#include "case/numerics_case.hpp"
#include "solver/fast_stepper.hpp"
#include "solver/make_backend.hpp"
#include "solver/paper_stepper.hpp"

namespace sabo::test {

/// Appends a particle at rest with the reference density of the model.
inline void add_particle(Particles& particles, const FlowModel& model, const Vec3d& position,
                         const Vec3d& velocity = {}) {
  const std::size_t i = particles.size();
  particles.resize(i + 1);
  particles.position[i] = position;
  particles.velocity[i] = velocity;
  particles.density[i] = model.state.rho0;
  particles.mass[i] = model.state.rho0 * std::pow(model.spacing, model.dimension);
  particles.id[i] = static_cast<std::uint32_t>(i);
}

/// Water-like, in three dimensions: for tests that are not about a material.
inline FlowModel plain_model(double spacing, double sound_speed, double viscosity) {
  FlowModel model;
  model.spacing = spacing;
  model.h = 1.5 * spacing;
  model.state = {1000, sound_speed};
  model.rheology = Newtonian{viscosity};
  model.threads = 1;
  return model;
}

/// The time step rule of the cases, for a model set up by hand.
inline TimeStepRule rule_of(const FlowModel& model) {
  return {model.h, model.state.c0, 0.2,
          default_viscous_cfl(model.viscous_operator, model.as_printed)};
}

/// The rule of the fast method, for a model set up by hand.
inline FastRule fast_rule_of(const FlowModel& model) {
  FastRule rule;
  rule.h = model.h;
  rule.slowest_sound = model.state.c0;
  return rule;
}

/// A stepper of either method for a model set up by hand.
inline std::unique_ptr<Stepper> stepper_of(Method method, Backend& backend,
                                           Domain* domain = nullptr) {
  if (method == Method::fast)
    return std::make_unique<FastStepper>(backend, fast_rule_of(backend.model()), domain);
  return std::make_unique<PaperStepper>(backend, rule_of(backend.model()), domain);
}

inline constexpr Method both_methods[] = {Method::fast, Method::paper};

/// Fills the cells [from, to) of the lattice with spacing dp, one particle at each centre. In two
/// dimensions y = 0.
struct Cells {
  int x0, x1, y0, y1, z0, z1;
};
inline void add_block(Particles& particles, const FlowModel& model, const Cells& cells) {
  const double dp = model.spacing;
  const bool flat = model.dimension == 2;
  for (int k = cells.z0; k < cells.z1; ++k)
    for (int j = flat ? 0 : cells.y0; j < (flat ? 1 : cells.y1); ++j)
      for (int i = cells.x0; i < cells.x1; ++i)
        add_particle(particles, model, {(i + 0.5) * dp, flat ? 0 : (j + 0.5) * dp, (k + 0.5) * dp});
}

/// A layer of fluid `cells` thick on a floor at z = 0, or between that floor and a lid, periodic in
/// x (and y in three dimensions). Gravity is any vector: a tilted one makes an incline.
struct Layer {
  FlowModel model;
  int cells = 10;
  int period = 8;  ///< in cells
  bool has_lid = false;
  std::unique_ptr<Backend> make(BackendKind kind = BackendKind::cpu) {
    const double dp = model.spacing;
    model.periodic.period[0] = {period * dp, 0, 0};
    if (model.dimension == 3) model.periodic.period[1] = {0, period * dp, 0};
    auto backend = make_backend(kind, model);
    const int layers = model.wall_layers();
    add_block(backend->fluid(), model, {0, period, 0, period, 0, cells});
    add_block(backend->boundary(), model, {0, period, 0, period, -layers, 0});
    if (has_lid)
      add_block(backend->boundary(), model, {0, period, 0, period, cells, cells + layers});
    return backend;
  }
};

/// Gives the fluid the density of a column at rest under `g` (m/s2, positive) with surface at z.
inline void make_hydrostatic(Backend& backend, double g, double surface) {
  const Tait state = backend.model().state;
  Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i)
    fluid.density[i] = state.density(state.rho0 * g * (surface - fluid.position[i].z));
}

/// Relative L2 error of the velocity along x against u(z).
inline double velocity_error(Backend& backend, const std::function<double(double)>& u) {
  double difference = 0, norm = 0;
  const Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const double exact = u(fluid.position[i].z);
    difference += (fluid.velocity[i].x - exact) * (fluid.velocity[i].x - exact);
    norm += exact * exact;
  }
  return std::sqrt(difference / norm);
}

}  // namespace sabo::test
