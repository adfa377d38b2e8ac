#include "bench/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "backend/cpu/cpu_backend.hpp"
#include "case/case.hpp"
#include "case/default_numerics.hpp"
#include "solver/flow_model.hpp"
#include "solver/lattice.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"

namespace sabo {
namespace {

constexpr int depth = 5;  // particles
constexpr double start_speed =
    0.05;  // over the sound speed: a list lasts five fast steps or fifteen

MaterialCase debris() {
  MaterialCase material;
  material.density = 1800;
  material.law = Cross{500, 1000, 1};
  material.yield = {0, 30, 0.5};
  return material;
}

NumericsCase debris_numerics(Method method, int threads) {
  NumericsCase numerics = default_numerics(method);
  numerics.threads = threads;
  numerics.spacing = 1;
  numerics.reference_speed = 15;
  return numerics;
}

FlowModel debris_model(Method method, int threads) {
  return flow_model(debris(), debris_numerics(method, threads), depth);
}

/// Density of the fluid at rest at a depth of `below_surface` (m).
double density_at(const FlowModel& model, double below_surface) {
  return model.state.density(model.state.rho0 * -model.gravity.z * std::max(0.0, below_surface));
}

void finish(BenchFlow& flow, const NumericsCase& numerics) {
  flow.stepper = make_stepper(numerics, *flow.backend, flow.domain.get());
}

/// Rough ground that falls by 0.36 m per m along x; a function of the place alone, so that the
/// same flow meets the same ground on maps of any size.
double rough_height(double x, double y) {
  return -0.36 * x + 0.3 * std::sin(x / 7) * std::cos(y / 5) + 0.1 * std::sin(1.3 * x + 0.7 * y);
}

Raster rough_map(int cells) {
  const double half = 0.5 * cells;
  Raster map(Grid{cells, cells, -half, half, 1, 1});
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column)
      map.at(column, row) = rough_height(map.grid.x_of(column), map.grid.y_of(row));
  return map;
}

constexpr double water_depth = 0.3, water_length = 0.4;  // m

/// Water, tank and column of dam_break(), walls of one layer, with a particle on each corner of the
/// lattice.
void fill_tank(Particles& water, Particles& walls, const FlowModel& model) {
  const double dp = model.spacing, half = 0.5 * dp;
  const auto corner = [&](double length) { return std::lround(length / dp) * dp; };
  const double length = corner(1.6), width = corner(0.67), height = corner(0.4);
  const Box inner{{half, half, half}, {length - half, width - half, height + half}};
  Tank{inner, 1}.add_to(walls, model);
  const double x0 = corner(0.9) - half, x1 = corner(1.02) + half;
  const double y0 = corner(0.24) - half, y1 = corner(0.36) + half;
  const double top = corner(0.45) + half, lid = top - dp;
  for (const Box& side : {Box{{x0, y0, half}, {x0 + dp, y1, lid}},
                          {{x1 - dp, y0, half}, {x1, y1, lid}},
                          {{x0 + dp, y0, half}, {x1 - dp, y0 + dp, lid}},
                          {{x0 + dp, y1 - dp, half}, {x1 - dp, y1, lid}},
                          {{x0, y0, lid}, {x1, y1, top}}})
    add_box(walls, model, side);
  const Vec3d end{corner(water_length) + half, inner.high.y, corner(water_depth) + half};
  add_box(water, model, {inner.low, end});
}

}  // namespace

BenchFlow cube_flow(const PairSweeps& sweeps, Method method, int side, int threads) {
  const FlowModel model = debris_model(method, threads);
  BenchFlow flow;
  flow.backend = std::make_unique<CpuBackend>(model, sweeps);
  add_block(flow.backend->fluid(), model, {0, side, 0, side, 0, side});
  finish(flow, debris_numerics(method, threads));
  return flow;
}

BenchFlow cube_on_floor(const PairSweeps& sweeps, Method method, int side, int threads) {
  const FlowModel model = debris_model(method, threads);
  BenchFlow flow;
  flow.backend = std::make_unique<CpuBackend>(model, sweeps);
  add_block(flow.backend->fluid(), model, {0, side, 0, side, 0, side});
  add_block(flow.backend->boundary(), model, {0, side, 0, side, -model.wall_layers(), 0});
  finish(flow, debris_numerics(method, threads));
  return flow;
}

namespace {

BenchFlow sliding_layer(BackendKind backend, Method method, int cells, int side, int threads) {
  const FlowModel model = debris_model(method, threads);
  BenchFlow flow;
  flow.backend = Layer{model, cells, side}.make(backend);
  make_hydrostatic(*flow.backend, cells * model.spacing);
  for (Vec3d& velocity : flow.backend->fluid().velocity)
    velocity = {start_speed * model.state.c0, 0, 0};
  finish(flow, debris_numerics(method, threads));
  return flow;
}

}  // namespace

BenchFlow layer_flow(Method method, int side, int threads) {
  return sliding_layer(BackendKind::cpu, method, depth, side, threads);
}

FlowModel layer_model(Method method) { return debris_model(method, 0); }

BenchFlow deep_layer_flow(BackendKind backend, Method method, int cells, int side) {
  return sliding_layer(backend, method, cells, side, 0);
}

int smallest_map_side(int side) {
  // Beyond the flow: the radius of the neighbour list (3.5), the rest of a tile of ground (8), its
  // slopes (1), and a way to go.
  return side + 2 * 24;
}

BenchFlow slope_flow(Method method, int side, int map_side, int threads) {
  const FlowModel model = debris_model(method, threads);
  const double dp = model.spacing;
  BenchFlow flow;
  flow.surface = std::make_unique<Surface>(rough_map(map_side));
  flow.ground = std::make_unique<Ground>(*flow.surface, std::vector<CheckDam>{},
                                         GroundSettings{dp, model.wall_layers(), model.state.rho0});
  flow.domain = std::make_unique<Domain>(*flow.ground);
  flow.backend = make_backend(BackendKind::cpu, model);
  Particles& fluid = flow.backend->fluid();
  add_block(fluid, model, {0, side, 0, side, 0, depth});
  const double speed = start_speed * model.state.c0;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    Vec3d& x = fluid.position[i];
    fluid.density[i] = density_at(model, depth * dp - x.z);
    x.x -= 0.5 * side * dp;
    x.y -= 0.5 * side * dp;
    x.z += flow.surface->height(x.x, x.y);
    fluid.velocity[i] = {speed, 0, -0.36 * speed};
  }
  finish(flow, debris_numerics(method, threads));
  return flow;
}

BenchFlow dam_break(Method method, double spacing, double h_over_dp, int threads) {
  MaterialCase material;
  material.density = 1000;
  material.law = Newtonian{0.001};
  NumericsCase numerics = default_numerics(method);
  numerics.threads = threads;
  numerics.spacing = spacing;
  numerics.h_over_dp = h_over_dp;
  numerics.sound_speed_factor = 20;
  numerics.diffusion_form = DiffusionForm::fourtakas;
  numerics.artificial_viscosity = 0.1;
  const FlowModel model = flow_model(material, numerics, water_depth);

  BenchFlow flow;
  flow.backend = make_backend(BackendKind::cpu, model);
  fill_tank(flow.backend->fluid(), flow.backend->boundary(), model);
  Particles& fluid = flow.backend->fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    // It runs out already, without changing its volume.
    const Vec3d& x = fluid.position[i];
    const double stretch = start_speed * model.state.c0 / water_length;
    fluid.velocity[i] = {stretch * x.x, 0, -stretch * x.z};
    fluid.density[i] = density_at(model, water_depth - x.z);
  }
  finish(flow, numerics);
  return flow;
}

int lattice_neighbours(double h_over_dp) {
  const double radius2 = 4 * h_over_dp * h_over_dp;
  const int reach = static_cast<int>(2 * h_over_dp);
  int count = -1;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k)
        if (i * i + j * j + k * k < radius2) ++count;
  return count;
}

}  // namespace sabo
