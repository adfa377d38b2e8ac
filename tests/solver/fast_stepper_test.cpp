#include "solver/fast_stepper.hpp"

#include <cmath>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "analysis/energy.hpp"
#include "base/error.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

/// A bumpy slope that falls by 0.5 m per m along x, 60 x 30 m.
Surface rough_slope() {
  Grid grid{61, 31, -0.5, 30.5, 1, 1};
  Raster elevation(grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      elevation.at(column, row) =
          -0.5 * grid.x_of(column) + 0.2 * std::sin(1.3 * column) * std::cos(0.9 * row);
  return Surface(std::move(elevation));
}

struct Slide {
  std::vector<Vec3d> position, velocity;
  std::vector<double> density;
  double time = 0, dissipated = 0;
  friend bool operator==(const Slide&, const Slide&) = default;
};

Slide slide(const Surface& surface, int threads) {
  FlowModel model = test::plain_model(0.5, 60, 50);
  model.rheology = Cross{100, 1000, 1};
  model.yield = {10, 20, 0.3};
  model.diffusion_form = DiffusionForm::fourtakas;
  model.threads = threads;
  Ground ground(surface, {}, {model.spacing, 3, 1000});
  Domain domain(ground);
  const auto backend = make_backend(BackendKind::cpu, model);
  test::add_block(backend->fluid(), model, {10, 40, 15, 45, 0, 5});
  for (Vec3d& x : backend->fluid().position) x.z += surface.height(x.x, x.y) + 0.1;
  FastStepper stepper(*backend, test::fast_rule_of(model), &domain);
  for (int step = 0; step < 100; ++step) stepper.step();
  const Particles& fluid = backend->fluid();
  return {fluid.position, fluid.velocity, fluid.density, stepper.time(), stepper.dissipated()};
}

TEST(FastStepper, GivesTheSameBitsForAnyNumberOfThreads) {
  const Surface surface = rough_slope();
  const Slide one = slide(surface, 1);
  EXPECT_EQ(one.position.size(), 4500u);  // enough for every loop to be shared
  EXPECT_GT(one.dissipated, 0);
  for (const int threads : {2, 4}) EXPECT_TRUE(slide(surface, threads) == one) << threads;
}

// Mass is carried by the particles; momentum changes by weight alone while nothing is touched.
TEST(FastStepper, KeepsMassAndMomentumInFlight) {
  FlowModel model = test::plain_model(0.1, 30, 20);
  const auto backend = make_backend(BackendKind::cpu, model);
  Particles& fluid = backend->fluid();
  test::add_block(fluid, model, {0, 6, 0, 6, 0, 6});
  for (std::size_t i = 0; i < fluid.size(); ++i)  // it shears and swirls
    fluid.velocity[i] = {3 + 2 * fluid.position[i].z, -fluid.position[i].x, 1};
  const auto momentum = [&] {
    Vec3d sum;
    double mass = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      sum += fluid.mass[i] * fluid.velocity[i];
      mass += fluid.mass[i];
    }
    EXPECT_NEAR(mass, 216, 1e-9);
    return sum;
  };
  const Vec3d start = momentum();
  FastStepper stepper(*backend, test::fast_rule_of(model), nullptr);
  while (stepper.time() < 0.3) stepper.step(0.3 - stepper.time());
  const Vec3d gained = momentum() - start;
  // Of a kick of 216 kg x 3 m/s: single precision in the sums, 1e-3 g dt in the solve.
  EXPECT_NEAR(gained.x, 0, 1e-3 * 648);
  EXPECT_NEAR(gained.y, 0, 1e-3 * 648);
  EXPECT_NEAR(gained.z, -216 * 9.81 * 0.3, 1e-3 * 648);
}

struct SlumpEnergy {
  double released = 0;     ///< potential energy, J
  double dissipated = 0;   ///< by viscosity, J
  double unaccounted = 0;  ///< what there is too much in the end, J
};

/// A block of 1 m slumps on a floor.
SlumpEnergy slump(FlowModel model, double end_time) {
  model.dimension = 2;
  const auto backend = make_backend(BackendKind::cpu, model);
  test::add_block(backend->fluid(), model, {-10, 10, 0, 1, 0, 20});
  test::add_block(backend->boundary(), model, {-60, 60, 0, 1, -3, 0});
  test::make_hydrostatic(*backend, 1.0);
  FastStepper stepper(*backend, test::fast_rule_of(model), nullptr);
  const auto energy = [&] {
    return energy_of(backend->fluid(), model.gravity, backend->model().state,
                     !model.tension_at_surface);
  };
  const Energy start = energy();
  while (stepper.time() < end_time) stepper.step();
  const Energy end = energy();
  const double heat = stepper.dissipated() + backend->heat().numerical.total();
  return {start.potential - end.potential, stepper.dissipated(),
          end.total() + heat - start.total()};
}

// What a block loses in height is found again as motion, compression and heat, or in the account of
// what the scheme itself takes.
TEST(FastStepper, AccountsForEnergyWhileABlockSlumps) {
  FlowModel model = test::plain_model(0.05, 30, 100);
  model.artificial_viscosity = 0.02;
  const SlumpEnergy result = slump(model, 0.6);
  EXPECT_GT(result.released, 0.2 * 1000 * 9.81 * 0.5);
  EXPECT_GT(result.dissipated, 0.3 * result.released);
  EXPECT_NEAR(result.unaccounted, 0, 0.02 * result.released);
}

// What is torn stores no energy, and density that is put into it takes none.
TEST(FastStepper, AccountsForEnergyWhileGrainsTear) {
  FlowModel model = test::plain_model(0.05, 30, 0);
  model.rheology = Cross{20, 1000, 1};
  model.yield = {0, 25, 0};
  model.tension_at_surface = false;
  const SlumpEnergy result = slump(model, 1.2);
  EXPECT_GT(result.released, 0.5 * 1000 * 9.81 * 0.5);
  EXPECT_NEAR(result.unaccounted, 0, 0.03 * result.released);
}

/// A block that shears under a viscosity of 1e5 Pa s, stepped once with so many iterations.
StepReport stepped_once(int most_iterations) {
  FlowModel model = test::plain_model(0.1, 30, 1e5);
  const auto backend = make_backend(BackendKind::cpu, model);
  Particles& fluid = backend->fluid();
  test::add_block(fluid, model, {0, 8, 0, 8, 0, 8});
  for (std::size_t i = 0; i < fluid.size(); ++i)
    fluid.velocity[i] = {std::sin(30 * fluid.position[i].z), 0, 0};
  FastRule rule = test::fast_rule_of(model);
  rule.most_iterations = most_iterations;
  FastStepper stepper(*backend, rule, nullptr);
  return stepper.step();
}

TEST(FastStepper, HalvesAStepWhoseViscosityDoesNotConverge) {
  const StepReport whole = stepped_once(1000);
  const StepReport halved = stepped_once(6);
  const double halvings = std::log2(whole.dt / halved.dt);
  EXPECT_GE(halvings, 1);
  EXPECT_NEAR(halvings, std::round(halvings), 1e-9);
  EXPECT_LE(halved.iterations, 6 * (halvings + 1));
}

}  // namespace
}  // namespace sabo
