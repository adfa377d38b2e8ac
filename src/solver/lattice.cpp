#include "solver/lattice.hpp"

#include <algorithm>
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

void add_box(Particles& particles, const FlowModel& model, const Box& box, std::uint16_t body) {
  const bool is_flat = model.dimension == 2;
  const Vec3d size = box.high - box.low;
  const auto count = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(length / model.spacing)));
  };
  const int nx = count(size.x), ny = is_flat ? 1 : count(size.y), nz = count(size.z);
  const Vec3d cell{size.x / nx, is_flat ? 0 : size.y / ny, size.z / nz};
  const double mass = model.state.rho0 * cell.x * (is_flat ? 1 : cell.y) * cell.z;
  const double y0 = is_flat ? 0 : box.low.y;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        add_particle(particles, model,
                     {box.low.x + (i + 0.5) * cell.x, y0 + (j + 0.5) * cell.y,
                      box.low.z + (k + 0.5) * cell.z});
        particles.mass.back() = mass;
        particles.body.back() = body;
      }
}

void add_still_box(Particles& fluid, const FlowModel& model, const Box& box) {
  std::size_t i = fluid.size();
  add_box(fluid, model, box);
  for (; i < fluid.size(); ++i) {
    const double pressure = model.state.rho0 * model.gravity.z * (fluid.position[i].z - box.high.z);
    fluid.density[i] = model.state.density(pressure);
  }
}

void Tank::add_to(Particles& boundary, const FlowModel& model) const {
  const double t = (layers > 0 ? layers : model.wall_layers()) * model.spacing;
  const Vec3d &low = inner.low, &high = inner.high;
  const double south = low.y - t, north = high.y + t;
  add_box(boundary, model, {{low.x - t, south, low.z - t}, {high.x + t, north, low.z}});
  add_box(boundary, model, {{low.x - t, south, low.z}, {low.x, north, high.z}});
  add_box(boundary, model, {{high.x, south, low.z}, {high.x + t, north, high.z}});
  if (model.dimension == 2) return;
  add_box(boundary, model, {{low.x, south, low.z}, {high.x, low.y, high.z}});
  add_box(boundary, model, {{low.x, high.y, low.z}, {high.x, north, high.z}});
}

void mark_foundation(Particles& boundary, const Box& box, std::uint16_t body) {
  for (std::size_t b = 0; b < boundary.size(); ++b) {
    const Vec3d& x = boundary.position[b];
    if (boundary.body[b] == 0 && x.z < box.low.z && x.x > box.low.x && x.x < box.high.x &&
        x.y > box.low.y && x.y < box.high.y)
      boundary.body[b] = static_cast<std::uint16_t>(body | foundation_mark);
  }
}

void make_hydrostatic(Backend& backend, double surface) {
  const Tait state = backend.model().state;
  const double g = -backend.model().gravity.z;
  Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i)
    fluid.density[i] = state.density(state.rho0 * g * (surface - fluid.position[i].z));
}

FlowModel Layer::periodic_model() const {
  FlowModel periodic = model;
  periodic.periodic.period[0] = {period * model.spacing, 0, 0};
  if (model.dimension == 3) periodic.periodic.period[1] = {0, period * model.spacing, 0};
  return periodic;
}

void Layer::fill(Backend& backend) const {
  const int layers = model.wall_layers();
  add_block(backend.fluid(), model, {0, period, 0, period, 0, cells});
  add_block(backend.boundary(), model, {0, period, 0, period, -layers, 0});
  if (has_lid) add_block(backend.boundary(), model, {0, period, 0, period, cells, cells + layers});
}

std::unique_ptr<Backend> Layer::make(BackendKind kind) const {
  auto backend = make_backend(kind, periodic_model());
  fill(*backend);
  return backend;
}

}  // namespace sabo
