#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "math/angle.hpp"

// Deposits that sleep and wake, on every backend.

namespace sabo {
namespace {

using test::Layer;

/// A frictional layer 3 m deep on 10 deg, phi 28 deg: at mu_0/mu_inf = 1e4 its surface creeps at
/// x rho g cos(theta) tan(phi) H^2 / (2 mu_0), x = r/(1 - r), r = tan(10)/tan(28): 1.6 mm/s.
Layer creeping_layer() {
  Layer layer;
  layer.model.dimension = 2;
  layer.cells = 6;
  layer.period = 40;
  layer.model.spacing = 0.5;
  layer.model.h = 0.75;
  layer.model.state = {1726, 55};
  layer.model.gravity = {9.81 * std::sin(10 * degree), 0, -9.81 * std::cos(10 * degree)};
  layer.model.diffusion_form = DiffusionForm::fourtakas;
  layer.model.rheology = Cross{1255, 1e4, 1};
  layer.model.yield = {0, 28, 0};
  layer.model.sleep = {0.005, 0.5};
  layer.model.threads = 1;
  return layer;
}

class Sleep : public test::OnBackend {
 protected:
  std::unique_ptr<Backend> settled(Layer& layer) {
    auto backend = test::make_backend(GetParam(), layer.periodic_model());
    layer.fill(*backend);
    test::make_hydrostatic(*backend, layer.cells * layer.model.spacing);
    return backend;
  }
};

INSTANTIATE_TEST_SUITE_P(On, Sleep, testing::ValuesIn(test::all_backends), test::name_of_backend);

TEST_P(Sleep, ADepositBelowYieldFallsAsleepAndStaysWhereItIs) {
  Layer layer = creeping_layer();
  auto backend = settled(layer);
  FastStepper stepper(*backend, test::fast_rule_of(layer.model), nullptr);
  while (stepper.time() < 0.3) stepper.step();
  EXPECT_EQ(backend->asleep_count(), 0u);  // half a second has not passed
  while (stepper.time() < 1.2) stepper.step();
  EXPECT_EQ(backend->asleep_count(), backend->fluid().size());
  const std::vector<Vec3d> before = backend->fluid().position;
  while (stepper.time() < 2) stepper.step();
  EXPECT_EQ(backend->fluid().position, before);
}

TEST_P(Sleep, MotionWakesWhatIsNearAndNothingElse) {
  Layer layer = creeping_layer();
  auto backend = settled(layer);
  FastStepper stepper(*backend, test::fast_rule_of(layer.model), nullptr);
  while (stepper.time() < 1.2) stepper.step();
  ASSERT_EQ(backend->asleep_count(), backend->fluid().size());
  // One grain at the surface, at the middle, is kicked just before a look at who sleeps: its
  // sleeping neighbours would stop it within a step or two.
  while (stepper.steps() % 16 != 0) stepper.step();
  Particles& deposit = backend->fluid();
  std::size_t kicked = 0;
  for (std::size_t i = 0; i < deposit.size(); ++i)
    if (norm(deposit.position[i] - Vec3d{10.25, 0, 2.75}) <
        norm(deposit.position[kicked] - Vec3d{10.25, 0, 2.75}))
      kicked = i;
  deposit.velocity[kicked].x = 1;
  deposit.calm[kicked] = 0;
  backend->find_neighbours();
  stepper.step();
  const Particles& fluid = backend->fluid();
  EXPECT_GT(fluid.size() - backend->asleep_count(), 5u);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    if (std::abs(fluid.position[i].x - 10.25) > 5) {
      EXPECT_EQ(norm(fluid.velocity[i]), 0);
    }
  }
}

TEST_P(Sleep, AFlowAboveYieldStaysAwake) {
  Layer layer = creeping_layer();
  layer.model.gravity = {9.81 * std::sin(33 * degree), 0, -9.81 * std::cos(33 * degree)};
  auto backend = settled(layer);
  FastStepper stepper(*backend, test::fast_rule_of(layer.model), nullptr);
  while (stepper.time() < 1.2) stepper.step();
  EXPECT_EQ(backend->asleep_count(), 0u);
}

}  // namespace
}  // namespace sabo
