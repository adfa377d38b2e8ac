#include "verify/cases/tilted_layer.hpp"

#include <cmath>

#include "solver/lattice.hpp"
#include "solver/make_backend.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

/// The plane around one period.
Surface plane(double spacing) {
  const int margin = 8;
  const int columns = TiltedLayer::columns + 2 * margin, rows = TiltedLayer::width + 2 * margin;
  Raster map(Grid{columns, rows, -margin * spacing, (TiltedLayer::width + margin) * spacing,
                  spacing, spacing});
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      map.at(column, row) = -map.grid.x_of(column) * std::tan(TiltedLayer::slope);
  return Surface(std::move(map));
}

}  // namespace

double TiltedLayer::along(const Vec3d& v) { return v.x * std::cos(slope) - v.z * std::sin(slope); }
double TiltedLayer::height(const Vec3d& x) { return x.x * std::sin(slope) + x.z * std::cos(slope); }

std::unique_ptr<Backend> TiltedLayer::make() const {
  const double dp = model.spacing, period = columns * dp;
  FlowModel periodic = model;
  periodic.periodic.period[0] = {period, 0, -period * std::tan(slope)};
  periodic.periodic.period[1] = {0, width * dp, 0};
  auto backend = make_backend(BackendKind::cpu, periodic);
  const Surface surface = plane(dp);
  Ground ground(surface, {}, {dp, model.wall_layers(), model.state.rho0});
  ground.make_all(0, 0, period, width * dp, backend->boundary());

  const double step = period / std::cos(slope) / rows;  // along the slope
  const double weight = -model.gravity.z * std::cos(slope) * model.state.rho0;
  Particles& fluid = backend->fluid();
  for (int k = 0; k < cells; ++k)
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < rows; ++i) {
        const double s = (i + 0.5) * step, h = (k + 0.5) * dp;
        add_particle(fluid, model,
                     {s * std::cos(slope) + h * std::sin(slope), (j + 0.5) * dp,
                      -s * std::sin(slope) + h * std::cos(slope)});
        fluid.density.back() = model.state.density(weight * (cells * dp - h));
        fluid.mass.back() *= step / dp;
      }
  return backend;
}

}  // namespace sabo
