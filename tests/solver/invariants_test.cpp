#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "support/random_flow.hpp"
#include <gtest/gtest.h>

#include "base/host_loops.hpp"

// Laws that hold for every flow, over random small ones, on every backend.

namespace sabo {
namespace {

using test::Moving;
using test::RandomFlow;

constexpr unsigned flows = 30;
constexpr int steps = 8;

using ByParticle = std::map<std::uint32_t, Vec3d>;

ByParticle velocities(const Moving& moving) {
  ByParticle values;
  const Particles& fluid = moving.backend->fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) values[fluid.id[i]] = fluid.velocity[i];
  return values;
}

/// What the flow made of its velocities.
ByParticle change(const RandomFlow& flow, const ByParticle& after) {
  ByParticle values;
  for (std::size_t i = 0; i < flow.fluid.size(); ++i)
    values[flow.fluid.id[i]] = after.at(flow.fluid.id[i]) - flow.fluid.velocity[i];
  return values;
}

ByParticle change_in(test::On on, const RandomFlow& flow, bool has_walls) {
  Moving moving(on, flow, has_walls);
  moving.go(steps);
  return change(flow, velocities(moving));
}

double largest_of(const ByParticle& values) {
  double largest = 0;
  for (const auto& [id, value] : values) largest = std::max(largest, norm(value));
  return largest;
}

/// Greatest difference between changes over the greatest change; `turn` brings the first into the
/// frame of the second.
double apart(
    const ByParticle& a, const ByParticle& b,
    const std::function<Vec3d(const Vec3d&)>& turn = [](const Vec3d& v) { return v; }) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (const auto& [id, value] : a) most = std::max(most, norm(turn(value) - b.at(id)));
  return most / largest_of(a);
}

class Invariants : public test::OnBackend {
 protected:
  void for_each_flow(const std::function<void(RandomFlow&)>& law, unsigned count = flows,
                     int size = 5) {
    for (unsigned seed = 0; seed < count; ++seed) {
      RandomFlow flow(seed, size);
      SCOPED_TRACE("flow " + std::to_string(seed) + ", " + std::string(word_of(flow.method)) +
                   ", " + std::string(name_of(flow.model.rheology)));
      law(flow);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(On, Invariants, testing::ValuesIn(test::all_backends),
                         test::name_of_backend);

TEST_P(Invariants, EveryParticleKeepsItsMass) {
  for_each_flow([&](RandomFlow& flow) {
    Moving moving(GetParam(), flow, true);
    moving.go(steps);
    std::map<std::uint32_t, double> before, after;
    const Particles& fluid = moving.backend->fluid();
    for (std::size_t i = 0; i < flow.fluid.size(); ++i)
      before[flow.fluid.id[i]] = flow.fluid.mass[i];
    for (std::size_t i = 0; i < fluid.size(); ++i) after[fluid.id[i]] = fluid.mass[i];
    EXPECT_EQ(before, after);
    EXPECT_EQ(fluid.size(), flow.fluid.size());
  });
}

// Forces between particles add up to nothing: what is left is the weight.
TEST_P(Invariants, MomentumIsThatOfTheWeight) {
  for_each_flow([&](RandomFlow& flow) {
    flow.model.central = {};
    Moving moving(GetParam(), flow, false);
    moving.go(steps);
    Vec3d change_of_momentum;
    double mass = 0, forces = 0;
    const ByParticle changes = change(flow, velocities(moving));
    for (std::size_t i = 0; i < flow.fluid.size(); ++i) {
      const Vec3d force = flow.fluid.mass[i] * changes.at(flow.fluid.id[i]);
      change_of_momentum += force;
      forces += norm(force);
      mass += flow.fluid.mass[i];
    }
    const Vec3d weight = mass * moving.stepper->time() * flow.model.gravity;
    EXPECT_LT(norm(change_of_momentum - weight), 2e-6 * forces);
  });
}

TEST_P(Invariants, AFlowThatMovesAsAWholeIsTheSame) {
  for_each_flow([&](RandomFlow& flow) {
    flow.model.central = {};
    const ByParticle still = change_in(GetParam(), flow, false);
    const Vec3d velocity = 5 * flow.any_direction();
    for (Vec3d& v : flow.fluid.velocity) v += velocity;
    EXPECT_LT(apart(still, change_in(GetParam(), flow, false)), 2e-5);
  });
}

TEST_P(Invariants, APlaceFarAwayIsTheSame) {
  for_each_flow([&](RandomFlow& flow) {
    const ByParticle here = change_in(GetParam(), flow, true);
    const Vec3d offset{4096, flow.is_flat() ? 0.0 : -2048, 512};
    flow.model.central.origin += offset;
    for (Vec3d& x : flow.fluid.position) x += offset;
    for (Vec3d& x : flow.walls_beneath.position) x += offset;
    EXPECT_LT(apart(here, change_in(GetParam(), flow, true)), 2e-5);
  });
}

TEST_P(Invariants, AFlowThatIsTurnedIsTheSameTurned) {
  for_each_flow([&](RandomFlow& flow) {
    // By 0.7 about an axis (Rodrigues), in two dimensions that across the plane.
    const Vec3d drawn = flow.any_direction();
    const Vec3d axis = flow.is_flat() ? Vec3d{0, 1, 0} : 1 / norm(drawn) * drawn;
    const auto turn = [&](const Vec3d& v) {
      return std::cos(0.7) * v + std::sin(0.7) * cross(axis, v) +
             (1 - std::cos(0.7)) * dot(axis, v) * axis;
    };
    const ByParticle before = change_in(GetParam(), flow, true);
    for (Particles* set : {&flow.fluid, &flow.walls_beneath})
      for (std::size_t i = 0; i < set->size(); ++i) {
        set->position[i] = turn(set->position[i]);
        set->velocity[i] = turn(set->velocity[i]);
      }
    flow.model.gravity = turn(flow.model.gravity);
    flow.model.central.origin = turn(flow.model.central.origin);
    EXPECT_LT(apart(before, change_in(GetParam(), flow, true), turn), 2e-5);
  });
}

TEST_P(Invariants, TheOrderOfParticlesDoesNotMatter) {
  for_each_flow([&](RandomFlow& flow) {
    const ByParticle before = change_in(GetParam(), flow, true);
    flow.fluid.permute(flow.any_order(flow.fluid.size()));
    flow.walls_beneath.permute(flow.any_order(flow.walls_beneath.size()));
    EXPECT_LT(apart(before, change_in(GetParam(), flow, true)), 2e-5);
  });
}

TEST_P(Invariants, ViscosityNeverGivesEnergy) {
  for_each_flow([&](RandomFlow& flow) {
    Moving moving(GetParam(), flow, true);
    double before = 0;
    for (int k = 0; k < steps; ++k) {
      moving.go(1);
      EXPECT_GE(moving.stepper->dissipated(), before);
      before = moving.stepper->dissipated();
    }
  });
}

TEST_P(Invariants, ThreadsDoNotMatter) {
  if (GetParam() == test::On::reference) GTEST_SKIP() << "it goes through all pairs: a minute";
  const int size = 17;  // enough for loops to be shared
  ASSERT_GT(size * size * size, worth_threads);
  // Sums over all particles show in the heat alone.
  const auto outcome = [&](const RandomFlow& flow) {
    Moving moving(GetParam(), flow, true);
    moving.go(steps);
    return std::pair{velocities(moving), moving.stepper->dissipated()};
  };
  const auto law = [&](RandomFlow& flow) {
    const auto one = outcome(flow);
    for (const int threads : {2, 5}) {
      flow.model.threads = threads;
      const auto more = outcome(flow);
      EXPECT_TRUE(more.first == one.first) << threads;
      EXPECT_EQ(more.second, one.second) << threads;
    }
  };
  for_each_flow(law, 4, size);
}

}  // namespace
}  // namespace sabo
