#include <cmath>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "analysis/energy.hpp"
#include "base/error.hpp"
#include "math/angle.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

using test::g;
using test::Layer;
using test::make_hydrostatic;
using test::plain_model;
using test::rule_of;

Layer still_water(int dimension, int cells) {
  Layer layer;
  layer.model = plain_model(1.0 / cells, 10 * std::sqrt(g), 1);
  layer.model.dimension = dimension;
  layer.cells = cells;
  return layer;
}

/// Relative L2 error of the pressure against rho0 g (surface - z).
double pressure_error(Backend& backend, double surface) {
  backend.pressure();
  double difference = 0, norm = 0;
  const Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const double exact = 1000 * g * (surface - fluid.position[i].z);
    difference += (fluid.pressure[i] - exact) * (fluid.pressure[i] - exact);
    norm += exact * exact;
  }
  return std::sqrt(difference / norm);
}

class Rest : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Both, Rest, testing::ValuesIn(test::both_methods),
                         [](const auto& method) { return std::string(word_of(method.param)); });

TEST_P(Rest, AColumnKeepsItsHydrostaticPressure) {
  for (const int dimension : {2, 3}) {
    Layer layer = still_water(dimension, 20);
    if (GetParam() == Method::fast) layer.model.diffusion_form = DiffusionForm::fourtakas;
    auto backend = layer.make();
    make_hydrostatic(*backend, 1.0);
    const auto stepper = test::stepper_of(GetParam(), *backend);
    while (stepper->time() < (dimension == 2 ? 3 : 0.5)) stepper->step();
    double top = 0, fastest = 0;
    for (std::size_t i = 0; i < backend->fluid().size(); ++i) {
      top = std::max(top, backend->fluid().position[i].z);
      fastest = std::max(fastest, norm(backend->fluid().velocity[i]));
    }
    EXPECT_LT(pressure_error(*backend, top + 0.5 * layer.model.spacing), 0.1) << dimension;
    EXPECT_NEAR(top, 0.975, 0.5 * layer.model.spacing) << dimension;
    EXPECT_LT(fastest, 0.02 * std::sqrt(g)) << dimension;
  }
}

// The floor under it takes its pressure from the fluid near it and the weight between (Adami et al.
// 2012): it carries the column at once, whatever it carried before. A floor with a density of its
// own does not.
TEST_P(Rest, TheFloorCarriesTheColumnAtOnce) {
  Layer layer = still_water(3, 20);
  layer.model.diffusion_form = DiffusionForm::fourtakas;
  layer.model.boundary_pressure = BoundaryPressure::extrapolated;
  auto backend = layer.make();
  make_hydrostatic(*backend, 1.0);
  const auto stepper = test::stepper_of(GetParam(), *backend);
  stepper->step();
  for (double& density : backend->boundary().density) density = layer.model.state.rho0;
  stepper->step();
  double sum = 0;
  int count = 0;
  const Particles& floor = backend->boundary();
  for (std::size_t i = 0; i < floor.size(); ++i)
    if (floor.position[i].z > -layer.model.spacing) {
      sum += floor.pressure[i];
      ++count;
    }
  EXPECT_NEAR(sum / count, 1000 * g * 1.025, 0.03 * 1000 * g);
}

// Water 0.5 m deep in a box of 1 x 0.5 m with walls on all sides, off hydrostatic at the start.
TEST_P(Rest, AClosedBoxKeepsItsWater) {
  FlowModel model = still_water(3, 20).model;
  model.diffusion_form = DiffusionForm::fourtakas;
  auto backend = make_backend(BackendKind::cpu, model);
  test::add_block(backend->fluid(), model, {0, 20, 0, 10, 0, 10});
  test::add_block(backend->boundary(), model, {-3, 23, -3, 13, -3, 0});
  for (const test::Cells wall : {test::Cells{-3, 0, -3, 13, 0, 16},
                                 {20, 23, -3, 13, 0, 16},
                                 {0, 20, -3, 0, 0, 16},
                                 {0, 20, 10, 13, 0, 16}})
    test::add_block(backend->boundary(), model, wall);
  const auto stepper = test::stepper_of(GetParam(), *backend);
  // By the fast method, which damps sound little, it rings for a second or two.
  stepper->advance_to(GetParam() == Method::fast ? 3 : 1);
  EXPECT_EQ(backend->fluid().size(), 2000u);
  for (const Vec3d& x : backend->fluid().position) {
    EXPECT_TRUE(x.x > 0 && x.x < 1 && x.y > 0 && x.y < 0.5 && x.z > 0 && x.z < 0.6);
  }
  EXPECT_LT(pressure_error(*backend, 0.5), 0.1);
}

// A pond over a bumpy DEM, 1 to 1.4 m deep within a steep rim, laid out on the lattice: once the
// lattice has found its way into the gaps above the ground it stays level and at rest.
TEST(FastRest, APondStaysOnABumpyDem) {
  const Grid grid{25, 25, -6.25, 6.25, 0.5, 0.5};
  Raster elevation(grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const double x = grid.x_of(column), y = grid.y_of(row);
      const bool is_rim = std::max(std::abs(x), std::abs(y)) > 2.6;
      elevation.at(column, row) = is_rim ? 3 : 0.2 * std::sin(1.7 * x) * std::cos(1.3 * y);
    }
  const Surface surface{std::move(elevation)};
  FlowModel model = plain_model(0.2, 10 * std::sqrt(g * 1.4), 100);
  model.diffusion_form = DiffusionForm::fourtakas;
  Ground ground(surface, {}, {model.spacing, 3, 1000});
  Domain domain(ground);
  auto backend = make_backend(BackendKind::cpu, model);
  Particles block;
  test::add_block(block, model, {-15, 15, -15, 15, -1, 6});
  for (const Vec3d& x : block.position)
    if (x.z > surface.height(x.x, x.y) + 0.3 * model.spacing)
      test::add_particle(backend->fluid(), model, x);
  make_hydrostatic(*backend, 1.2);
  const std::size_t count = backend->fluid().size();
  EXPECT_GT(count, 3000u);
  const auto stepper = test::stepper_of(Method::fast, *backend, &domain);
  while (stepper->time() < 3) stepper->step();
  const Particles& fluid = backend->fluid();
  double energy = 0, top = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    energy += dot(fluid.velocity[i], fluid.velocity[i]) / static_cast<double>(count);
    top = std::max(top, fluid.position[i].z);
    // A tenth of a spacing is tolerated when the list is renewed; by the next renewal a particle
    // may have gone the skin of 0.3 h farther, as it does in a corner of the rim.
    EXPECT_LT(norm(ground.pushed_out(fluid.position[i]) - fluid.position[i]),
              0.1 * model.spacing + 0.3 * model.h);
  }
  EXPECT_EQ(fluid.size(), count);
  EXPECT_LT(std::sqrt(energy), 0.01 * std::sqrt(g * 1.2));
  EXPECT_LT(top, 1.2 + 0.5 * model.spacing);
  EXPECT_GT(top, 1.2 - 1.5 * model.spacing);
}

// A block of viscous fluid slumps on a floor: what it loses in height is found again as motion,
// compression and heat, or in the account of what density diffusion and the walls, which are
// clamped, have taken.
TEST(Energy, IsAccountedForWhileABlockSlumps) {
  FlowModel model = plain_model(0.05, 30, 100);
  model.dimension = 2;
  for (const test::On kind : test::backends()) {
    auto backend = test::make_backend(kind, model);
    test::add_block(backend->fluid(), model, {-10, 10, 0, 1, 0, 20});
    test::add_block(backend->boundary(), model, {-40, 40, 0, 1, -3, 0});
    make_hydrostatic(*backend, 1.0);
    PaperStepper stepper(*backend, rule_of(model), nullptr);
    const auto energy = [&] { return energy_of(backend->fluid(), model.gravity, model.state); };
    const Energy start = energy();
    while (stepper.time() < 0.3) stepper.step();
    const Energy end = energy();
    const NumericalHeat& taken = backend->heat().numerical;
    const double released = start.potential - end.potential;
    EXPECT_GT(released, 0.1 * 1000 * g * 0.5);  // it slumped
    EXPECT_GT(stepper.dissipated(), 0.2 * released);
    EXPECT_GT(taken.density_diffusion, 0);
    EXPECT_NEAR(end.total() + stepper.dissipated() + taken.total(), start.total(),
                0.002 * released);
  }
}

TEST(FreeFall, KeepsToTheParabola) {
  const FlowModel model = plain_model(0.1, 10, 1);
  for (const test::On kind : test::backends()) {
    auto backend = test::make_backend(kind, model);
    test::add_block(backend->fluid(), model, {0, 4, 0, 4, 0, 4});
    for (Vec3d& v : backend->fluid().velocity) v = {3, 0, 1};
    const Vec3d start = backend->fluid().position[0];
    const std::uint32_t id = backend->fluid().id[0];
    PaperStepper stepper(*backend, rule_of(model), nullptr);
    while (stepper.time() < 0.5) stepper.step(0.5 - stepper.time());
    int hits = 0;
    for (std::size_t i = 0; i < backend->fluid().size(); ++i) {
      if (backend->fluid().id[i] != id) continue;
      ++hits;
      const Vec3d d = backend->fluid().position[i] - start;
      EXPECT_NEAR(d.x, 3 * 0.5, 1e-5);
      EXPECT_NEAR(d.z, 0.5 - g * 0.125, 1e-5);
    }
    EXPECT_EQ(hits, 1);
  }
}

TEST(Stepper, StopsWhenTheDensityLeavesItsRange) {
  const FlowModel model = plain_model(0.1, 10, 1);
  auto backend = make_backend(BackendKind::cpu, model);
  test::add_block(backend->fluid(), model, {0, 4, 0, 4, 0, 4});
  for (std::size_t i = 0; i < backend->fluid().size(); ++i)  // implodes at Mach 1
    backend->fluid().velocity[i] =
        -10.0 * (backend->fluid().position[i] - Vec3d{0.2, 0.2, 0.2}) * 5.0;
  PaperStepper stepper(*backend, rule_of(model), nullptr);
  EXPECT_THROW(for (int k = 0; k < 200; ++k) stepper.step(), RunError);
}

TEST(Stepper, StopsOnANumberThatIsNone) {
  const FlowModel model = plain_model(0.1, 10, 1);
  for (const test::On kind : test::backends()) {
    auto backend = test::make_backend(kind, model);
    test::add_block(backend->fluid(), model, {0, 4, 0, 4, 0, 4});
    PaperStepper stepper(*backend, rule_of(model), nullptr);
    stepper.step();
    backend->fluid().velocity[7].y = std::nan("");
    backend->find_neighbours();
    EXPECT_THROW(stepper.step(), RunError);
  }
}

// A slab below its friction angle creeps at a few mm/s, far less than gravity adds in a step: the
// heat is still the work of gravity along the slope.
TEST(Energy, OfCreepBecomesHeat) {
  Layer layer;
  layer.model = plain_model(0.75, 10 * std::sqrt(g * 3.75), 1);
  layer.model.dimension = 2;
  layer.model.state.rho0 = 1726;
  layer.model.rheology = Cross{1255, 1000, 1};
  layer.model.yield = {0, 28, 0};
  layer.model.diffusion_form = DiffusionForm::fourtakas;
  const double slope = 16 * degree;
  layer.model.gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
  layer.cells = 5;
  const auto backend = layer.make();
  make_hydrostatic(*backend, 3.75);
  const auto stepper = test::stepper_of(Method::fast, *backend);
  double work = 0;
  while (stepper->time() < 5) {
    const double dt = stepper->step().dt;
    const Particles& fluid = backend->fluid();
    for (std::size_t i = 0; i < fluid.size(); ++i)
      work += dt * fluid.mass[i] * layer.model.gravity.x * fluid.velocity[i].x;
  }
  EXPECT_NEAR(stepper->dissipated(), work, 0.02 * work);
}

}  // namespace
}  // namespace sabo
