#include "solver/lattice.hpp"

#include <cmath>

#include "solver/make_backend.hpp"

namespace sabo {

void add_particle(Particles& particles, const FlowModel& model, const Vec3d& position,
                  const Vec3d& velocity) {
  const std::size_t i = particles.size();
  particles.resize(i + 1);
  particles.position[i] = position;
  particles.velocity[i] = velocity;
  particles.density[i] = model.state.rho0;
  particles.mass[i] = model.state.rho0 * std::pow(model.spacing, model.dimension);
  particles.id[i] = static_cast<std::uint32_t>(i);
}

void add_block(Particles& particles, const FlowModel& model, const Cells& cells) {
  const double dp = model.spacing;
  const bool is_flat = model.dimension == 2;
  const int y0 = is_flat ? 0 : cells.y0, y1 = is_flat ? 1 : cells.y1;
  for (int k = cells.z0; k < cells.z1; ++k)
    for (int j = y0; j < y1; ++j)
      for (int i = cells.x0; i < cells.x1; ++i)
        add_particle(particles, model,
                     {(i + 0.5) * dp, is_flat ? 0 : (j + 0.5) * dp, (k + 0.5) * dp});
}

void make_hydrostatic(Backend& backend, double surface) {
  const Tait state = backend.model().state;
  const double g = -backend.model().gravity.z;
  Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i)
    fluid.density[i] = state.density(state.rho0 * g * (surface - fluid.position[i].z));
}

std::unique_ptr<Backend> Layer::make(BackendKind kind) const {
  FlowModel periodic = model;
  periodic.periodic.period[0] = {period * model.spacing, 0, 0};
  if (model.dimension == 3) periodic.periodic.period[1] = {0, period * model.spacing, 0};
  auto backend = make_backend(kind, periodic);
  const int layers = model.wall_layers();
  add_block(backend->fluid(), model, {0, period, 0, period, 0, cells});
  add_block(backend->boundary(), model, {0, period, 0, period, -layers, 0});
  if (has_lid) add_block(backend->boundary(), model, {0, period, 0, period, cells, cells + layers});
  return backend;
}

}  // namespace sabo
