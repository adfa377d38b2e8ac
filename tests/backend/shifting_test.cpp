#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

constexpr double dp = 0.1;

FlowModel sheared(double shifting) {
  FlowModel model = test::plain_model(dp, 20, 1);
  model.dimension = 2;
  model.gravity = {};
  model.density_diffusion = 0;
  model.crowding_tolerance = 1;  // density by continuity and shifts alone
  model.particle_shifting = shifting;
  return model;
}

/// Particles displaced at random from a lattice, in shear.
void fill(Backend& backend, int cells) {
  Particles& fluid = backend.fluid();
  test::add_block(fluid, backend.model(), {0, cells, 0, 1, 0, cells});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-0.2 * dp, 0.2 * dp);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    fluid.position[i] += {u(random), 0, u(random)};
    fluid.velocity[i] = {3 * fluid.position[i].z, 0, 0};
  }
}

struct Shifted {
  std::map<std::uint32_t, Vec3d> position, velocity;
  double density = 0;  ///< mean
};

Shifted stepped_once(test::On kind, double shifting, bool is_periodic) {
  FlowModel model = sheared(shifting);
  if (is_periodic) model.periodic.period = {Vec3d{2, 0, 0}, Vec3d{}, Vec3d{0, 0, 2}};
  const auto backend = test::make_backend(kind, model);
  fill(*backend, 20);
  FastStepper stepper(*backend, test::fast_rule_of(model), nullptr);
  stepper.step(2e-3);
  const Particles& fluid = backend->fluid();
  Shifted state;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    state.position[fluid.id[i]] = fluid.position[i];
    state.velocity[fluid.id[i]] = fluid.velocity[i];
    state.density += fluid.density[i] / static_cast<double>(fluid.size());
  }
  return state;
}

TEST(Shifting, MovesTheInsideALittleAndNothingElse) {
  for (const test::On kind : test::backends()) {
    const Shifted plain = stepped_once(kind, 0, false), shifted = stepped_once(kind, 20, false);
    int moved = 0;
    for (const auto& [id, x] : plain.position) {
      const double distance = norm(shifted.position.at(id) - x);
      EXPECT_LE(distance, 0.1 * dp);
      EXPECT_EQ(shifted.velocity.at(id), plain.velocity.at(id));
      const double depth = std::min({x.x, x.z, 2 - x.x, 2 - x.z});
      if (depth < 0.9 * dp) {  // the outermost row
        EXPECT_EQ(distance, 0) << depth;
      }
      if (depth > 4 * dp && distance > 1e-3 * dp) ++moved;
    }
    EXPECT_GT(moved, 100);  // of 144 that deep
  }
}

// Density falls as the mean filling does, to first order in the shifts.
TEST(Shifting, TakesFillingAndDensityBackTogether) {
  for (const test::On kind : test::backends()) {
    const Shifted plain = stepped_once(kind, 0, true), shifted = stepped_once(kind, 4, true);
    const auto filling = [](const Shifted& state) {
      const auto kernel = WendlandC2<double>::make(1.5 * dp, 2);
      double sum = 0;
      for (const auto& [i, x] : state.position)
        for (const auto& [j, y] : state.position) {
          Vec3d d = x - y;
          d = {d.x - 2 * std::rint(d.x / 2), 0, d.z - 2 * std::rint(d.z / 2)};
          sum += dp * dp * kernel.value(norm(d)) / 400;
        }
      return sum;
    };
    const double emptied = filling(plain) - filling(shifted);
    EXPECT_GT(emptied, 1e-5);
    EXPECT_NEAR((plain.density - shifted.density) / 1000 / emptied, 1, 0.05);
  }
}

struct Account {
  double energy = 0;  ///< kinetic, potential and of compression, J
  double heat = 0;    ///< that shifting has taken, J
};

/// After a step of a compressed fluid, the same but for what shifting does.
Account account_of(test::On kind, double shifting) {
  FlowModel model = sheared(shifting);
  model.gravity = {0, 0, -9.81};
  model.periodic.period = {Vec3d{2, 0, 0}, Vec3d{}, Vec3d{0, 0, 2}};
  const auto backend = test::make_backend(kind, model);
  fill(*backend, 20);
  for (double& density : backend->fluid().density) density *= 1.01;
  FastStepper stepper(*backend, test::fast_rule_of(model), nullptr);
  stepper.step(2e-5);
  const Particles& fluid = backend->fluid();
  Account account{0, backend->heat().numerical.shifting};
  for (std::size_t i = 0; i < fluid.size(); ++i)
    account.energy += fluid.mass[i] * (0.5 * dot(fluid.velocity[i], fluid.velocity[i]) -
                                       dot(model.gravity, fluid.position[i]) +
                                       backend->model().state.elastic_energy(fluid.density[i]));
  return account;
}

// Here it gives: shifts of this size make the even density of disordered particles uneven.
TEST(Shifting, BooksTheEnergyThatItTakes) {
  for (const test::On kind : test::backends()) {
    const Account plain = account_of(kind, 0), shifted = account_of(kind, 400);
    EXPECT_EQ(plain.heat, 0);
    EXPECT_LT(shifted.heat, -1);
    EXPECT_NEAR((plain.energy - shifted.energy) / shifted.heat, 1, 0.05);
  }
}

TEST(Shifting, LeavesAFlowWithoutStrainAlone) {
  for (const test::On kind : test::backends()) {
    FlowModel model = sheared(20);
    const auto backend = test::make_backend(kind, model);
    fill(*backend, 12);
    for (Vec3d& v : backend->fluid().velocity) v = {5, 0, 1};
    std::map<std::uint32_t, Vec3d> start;
    for (std::size_t i = 0; i < 144; ++i)
      start[backend->fluid().id[i]] = backend->fluid().position[i];
    FastStepper stepper(*backend, test::fast_rule_of(model), nullptr);
    stepper.step(1e-3);
    for (std::size_t i = 0; i < 144; ++i) {
      const Vec3d moved = backend->fluid().position[i] - start[backend->fluid().id[i]];
      EXPECT_LT(norm(moved - Vec3d{5e-3, 0, 1e-3}), 1e-7);
    }
  }
}

}  // namespace
}  // namespace sabo
