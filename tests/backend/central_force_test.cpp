#include <cmath>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

// Hand-derived: x'' = -s (x - o) is an oscillation of the circular frequency sqrt(s) about o.

namespace sabo {
namespace {

constexpr double strength = 4;  // 1/s2

FlowModel free_model() {
  FlowModel model = test::plain_model(0.1, 20, 0);
  model.gravity = {0, 0, -1};
  model.central = {strength, {1, 2, 3}};
  return model;
}

void evaluate(Method method, Backend& backend) {
  backend.find_neighbours();
  backend.pressure();
  if (method == Method::fast) {
    backend.wall_pressure();
    backend.near_forces();
  } else {
    backend.strain_and_density_rates();
    backend.stress();
    backend.momentum();
  }
}

TEST(CentralForce, PullsEachParticleOfAPairTowardsItsOrigin) {
  for (const test::On kind : test::backends())
    for (const Method method : test::both_methods) {
      const auto backend = test::make_backend(kind, free_model());
      // Farther apart than the kernel, so that nothing else acts.
      test::add_particle(backend->fluid(), backend->model(), {1.5, 2, 3});
      test::add_particle(backend->fluid(), backend->model(), {1, 2, 2.5});
      evaluate(method, *backend);
      for (std::size_t i = 0; i < 2; ++i) {
        const Vec3d expected = backend->fluid().id[i] == 0 ? Vec3d{-2, 0, -1} : Vec3d{0, 0, 1};
        EXPECT_LT(norm(backend->accelerations()[i] - expected), 1e-12);
      }
    }
}

// Forces between particles add up to nothing: sum m a = sum m (g - s (x - o)).
TEST(CentralForce, GivesAFlowTheMomentumOfItsMoments) {
  for (const test::On kind : test::backends())
    for (const Method method : test::both_methods) {
      const auto backend = test::make_backend(kind, free_model());
      test::add_block(backend->fluid(), backend->model(), {0, 6, 0, 5, 0, 4});
      for (std::size_t i = 0; i < backend->fluid().size(); ++i)
        backend->fluid().density[i] *= 1 + 0.01 * std::sin(double(i));
      evaluate(method, *backend);
      Vec3d force;
      for (std::size_t i = 0; i < backend->fluid().size(); ++i)
        force += backend->fluid().mass[i] * backend->accelerations()[i];
      // 120 particles of 1 kg, their middle at (0.3, 0.25, 0.2).
      const Vec3d expected = 120.0 * Vec3d{4 * 0.7, 4 * 1.75, 4 * 2.8 - 1};
      EXPECT_LT(norm(force - expected), 1e-4 * norm(expected));
    }
}

TEST(CentralForce, IsNoHeat) {
  for (const test::On kind : test::backends()) {
    const auto backend = test::make_backend(kind, free_model());
    test::add_block(backend->fluid(), backend->model(), {0, 4, 0, 4, 0, 4});
    for (Vec3d& v : backend->fluid().velocity) v = {1, 2, 3};
    evaluate(Method::paper, *backend);
    EXPECT_NEAR(test::dissipated_power(*backend), 0, 1e-3);  // its power is 64 kg x 30 m2/s3
  }
}

// One particle swings along x with the amplitude 0.5 m; its energy (v^2 + s x^2) / 2 is 0.5 J/kg.
TEST(CentralForce, KeepsTheEnergyOfAnOscillation) {
  for (const test::On kind : test::backends())
    for (const Method method : test::both_methods) {
      FlowModel model = free_model();
      model.gravity = {};
      const auto backend = test::make_backend(kind, model);
      test::add_particle(backend->fluid(), model, {1.5, 2, 3});
      const auto stepper = test::stepper_of(method, *backend);
      const double period = M_PI;  // 2 pi / sqrt(4)
      while (stepper->time() < period) stepper->step(std::min(0.002, period - stepper->time()));
      const Vec3d x = backend->fluid().position[0] - model.central.origin;
      const Vec3d v = backend->fluid().velocity[0];
      EXPECT_NEAR(x.x, 0.5, 1e-3);
      EXPECT_NEAR(0.5 * (dot(v, v) + strength * dot(x, x)), 0.5, 1e-3);
    }
}

// A wall takes the pressure of the only fluid near it, carried along the force at its own place.
TEST(CentralForce, CarriesPressureToWalls) {
  for (const test::On kind : test::backends()) {
    const auto backend = test::make_backend(kind, free_model());
    test::add_particle(backend->fluid(), backend->model(), {1.4, 2, 3});
    test::add_particle(backend->boundary(), backend->model(), {1.5, 2, 3});
    backend->fluid().density[0] = 1001;
    backend->find_neighbours();
    backend->pressure();
    backend->wall_pressure();
    // 4 x 0.5 m/s2 back towards the origin, over 0.1 m outwards: 200 Pa less.
    const double expected = backend->model().state.pressure(1001) - 1001 * 2 * 0.1;
    EXPECT_NEAR(backend->boundary().pressure[0], expected, 1e-3);
  }
}

}  // namespace
}  // namespace sabo
