#include <cmath>
#include <memory>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

/// A block that falls freely at 5 m/s, one particle of which an inflow drives at `driven` m/s.
std::unique_ptr<Backend> falling(test::On kind, double driven = 5) {
  const FlowModel model = test::plain_model(0.1, 20, 0);
  auto backend = test::make_backend(kind, model);
  Particles& fluid = backend->fluid();
  test::add_block(fluid, model, {0, 4, 0, 4, 0, 4});
  for (Vec3d& v : fluid.velocity) v = {3, 0, -4};
  fluid.velocity[21] = {driven, 0, 0};
  fluid.driven[21] = 1;
  backend->find_neighbours();
  backend->pressure();
  backend->strain_and_density_rates();
  backend->stress();
  backend->momentum();
  return backend;
}

TEST(ChosenStep, IsThatOfTheFastestInTheFlow) {
  for (const test::On kind : test::backends()) {
    SCOPED_TRACE(test::word_of(kind));
    const auto backend = falling(kind);
    backend->choose_step(FastStepRule{0.15, 0.2, 20}, 1);
    ChosenStep step = backend->chosen_step();
    EXPECT_DOUBLE_EQ(step.flow.speed, 5);
    EXPECT_NEAR(step.flow.acceleration, 9.81, 1e-6);
    EXPECT_DOUBLE_EQ(step.dt, 0.2 * 0.15 / 25);

    backend->choose_step(FastStepRule{0.15, 10, 20}, 1);
    EXPECT_NEAR(backend->chosen_step().dt, 0.25 * std::sqrt(0.15 / 9.81), 1e-8);

    backend->choose_step(TimeStepRule{0.15, 20, 0.2, 0.23}, 1);
    EXPECT_DOUBLE_EQ(backend->chosen_step().dt, 0.2 * 0.15 / 50);

    backend->choose_step(FastStepRule{0.15, 0.2, 20}, 1e-4);
    EXPECT_EQ(backend->chosen_step().dt, 1e-4);

    backend->fix_step(0.5);
    step = backend->chosen_step();
    EXPECT_EQ(step.dt, 0.5);
    EXPECT_DOUBLE_EQ(step.flow.speed, 5);
  }
}

TEST(ChosenStep, HeedsParticlesThatAnInflowDrives) {
  for (const test::On kind : test::backends()) {
    SCOPED_TRACE(test::word_of(kind));
    const auto backend = falling(kind, 30);
    backend->choose_step(FastStepRule{0.15, 0.2, 20}, 1);
    EXPECT_DOUBLE_EQ(backend->chosen_step().dt, 0.2 * 0.15 / 50);
  }
}

// Free fall over 0.01 s from -4 m/s: -0.0404905 m, which the midpoint rule finds without error.
TEST(ChosenStep, IsTheOneByWhichTheStateMoves) {
  for (const test::On kind : test::backends()) {
    SCOPED_TRACE(test::word_of(kind));
    const auto backend = falling(kind);
    const auto first = [&] { return backend->fluid().position[0]; };
    const Vec3d before = first();
    backend->choose_step(FixedStep{0.02}, 0.01);
    backend->predict();
    EXPECT_NEAR(first().z - before.z, -0.02, 1e-9);
    backend->correct();
    EXPECT_NEAR(first().x - before.x, 0.03, 1e-9);
    EXPECT_NEAR(first().z - before.z, -0.0404905, 1e-8);
  }
}

}  // namespace
}  // namespace sabo
