#include "verify/cases/still_pool.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "solver/lattice.hpp"
#include "solver/make_backend.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

constexpr int across = 8;  // particles of a period

int cells_in(double length, double spacing) {
  return static_cast<int>(std::lround(length / spacing));
}

/// Lattice cells of the fluid that `is_free` accepts by their middle.
void fill(Backend& backend, const Cells& cells, const std::function<bool(const Vec3d&)>& is_free) {
  Particles block;
  add_block(block, backend.model(), cells);
  for (const Vec3d& x : block.position)
    if (is_free(x)) add_particle(backend.fluid(), backend.model(), x);
}

/// Columns that stand on the ground and reach up to `depth`, as those of a release do. Cells of one
/// lattice for all leave voids along the ground: what they give up in falling there moves them for
/// long, and the water breathes.
void stand_on(const Surface& surface, const std::array<int, 2>& columns, double depth,
              Backend& backend) {
  const double dp = backend.model().spacing;
  for (int i = 0; i < columns[0]; ++i)
    for (int j = 0; j < columns[1]; ++j) {
      const double x = (i + 0.5) * dp, y = (j + 0.5) * dp, foot = surface.height(x, y);
      for (int k = 0; k < cells_in(depth - foot, dp); ++k)
        add_particle(backend.fluid(), backend.model(), {x, y, foot + (k + 0.5) * dp});
    }
}

/// The volume (area) of the fluid and of the ground within it, over the area (length) in plan.
StillPool levelled(std::unique_ptr<Backend> backend, double ground_volume, double area) {
  double volume = ground_volume;
  for (const double mass : backend->fluid().mass) volume += mass / backend->model().state.rho0;
  StillPool pool{std::move(backend), volume / area};
  make_hydrostatic(*pool.backend, pool.level);
  return pool;
}

Surface surface_of(double width, double spacing,
                   const std::function<double(int column, int row)>& height) {
  constexpr int margin = 8;
  const int columns = cells_in(width, spacing) + 2 * margin, rows = across + 2 * margin;
  // Vertices, which are cell centres, between the columns of particles.
  Raster map(Grid{columns + 1, rows + 1, -(margin + 0.5) * spacing,
                  (across + margin + 0.5) * spacing, spacing, spacing});
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      map.at(column, row) = height(column - margin, row - margin);
  return Surface(std::move(map));
}

}  // namespace

StillPool column_pool(const FlowModel& model, double depth) {
  Layer layer{model, cells_in(depth, model.spacing), across};
  const bool is_flat = model.dimension == 2;
  const double width = across * model.spacing;
  return levelled(layer.make(), 0, is_flat ? width : width * width);
}

StillPool wedge_pool(const FlowModel& model, double depth) {
  constexpr double wedge = 0.4, width = 1.2;  // m
  const double dp = model.spacing;
  const int columns = cells_in(width, dp), layers = model.wall_layers();
  FlowModel periodic = model;
  periodic.periodic.period[0] = {columns * dp, 0, 0};
  auto backend = make_backend(BackendKind::cpu, periodic);
  // With the ridge in the middle of a column the flanks lie halfway between rows of particles.
  const double ridge = (columns / 2 + 0.5) * dp;
  const auto is_solid = [&](const Vec3d& x) { return x.z + std::abs(x.x - ridge) < wedge; };
  const Cells above{0, columns, 0, 1, 0, cells_in(depth, dp)};
  fill(*backend, above, [&](const Vec3d& x) { return !is_solid(x); });
  Particles block;
  add_block(block, model, above);
  for (const Vec3d& x : block.position)
    if (is_solid(x)) add_particle(backend->boundary(), model, x);
  add_block(backend->boundary(), model, {0, columns, 0, 1, -layers, 0});
  return levelled(std::move(backend), wedge * wedge, columns * dp);
}

StillPool dem_pool(const FlowModel& model, double depth, bool is_rough) {
  const double dp = model.spacing, width = across * dp;
  FlowModel periodic = model;
  periodic.periodic.period[0] = {width, 0, 0};
  periodic.periodic.period[1] = {0, width, 0};
  auto backend = make_backend(BackendKind::cpu, periodic);
  std::vector<double> heights(across * across, 0.0);
  double mean = 0;
  std::mt19937_64 random(1);
  for (double& height : heights) {
    if (is_rough) height = dp * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    mean += height / (across * across);
  }
  const auto wrapped = [](int k) { return ((k % across) + across) % across; };
  const Surface surface = surface_of(width, dp, [&](int column, int row) {
    return heights[wrapped(column) + across * wrapped(row)] - mean;
  });
  Ground ground(surface, {}, {dp, model.wall_layers(), model.state.rho0});
  ground.make_all(0, 0, width, width, backend->boundary());
  stand_on(surface, {across, across}, depth, *backend);
  return levelled(std::move(backend), 0, width * width);
}

StillPool box_pool(const FlowModel& model, double depth) {
  constexpr double width = 1;  // m
  const double slope = std::tan(std::numbers::pi / 6), dp = model.spacing;
  const int columns = cells_in(width, dp), layers = model.wall_layers();
  FlowModel periodic = model;
  periodic.periodic.period[1] = {0, across * dp, 0};
  auto backend = make_backend(BackendKind::cpu, periodic);
  const Surface surface =
      surface_of(width, dp, [&](int column, int) { return column * dp * slope; });
  Ground ground(surface, {}, {dp, layers, model.state.rho0});
  ground.make_all(0, 0, width, across * dp, backend->boundary());
  const int rim = cells_in(1.2 * depth, dp), corner = cells_in(width * slope, dp) - 2 * layers;
  add_block(backend->boundary(), model, {-layers, 0, 0, across, -2 * layers, rim});
  add_block(backend->boundary(), model, {columns, columns + layers, 0, across, corner, rim});
  stand_on(surface, {columns, across}, depth, *backend);
  const double area = width * across * dp;
  return levelled(std::move(backend), 0.5 * slope * width * area, area);
}

}  // namespace sabo
