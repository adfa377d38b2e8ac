#include <algorithm>
#include <map>
#include <memory>
#include <span>

#include "collapse.hpp"
#include "support/backends.hpp"
#include "support/clouds.hpp"
#include "support/scenes.hpp"
#include "support/viscous_step.hpp"
#include <gtest/gtest.h>

// What is peculiar to the backend for graphics cards: its copies on the host, its lists, its order.
// The sums themselves are in the tests of all backends.

namespace sabo {
namespace {

using test::add_particle;
using test::collapsing;
using test::fill;
using test::On;

class Device : public test::OnBackend {
 protected:
  std::unique_ptr<Backend> make(const FlowModel& model) {
    return test::make_backend(GetParam(), model);
  }
};

INSTANTIATE_TEST_SUITE_P(On, Device, testing::Values(On::device, On::cuda), test::name_of_backend);

using State = std::map<std::uint32_t, std::pair<Vec3d, Vec3d>>;

State state_of(Backend& backend) {
  State state;
  const Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i)
    state[fluid.id[i]] = {fluid.position[i], fluid.velocity[i]};
  return state;
}

/// After a fall of `steps`; `looks`: the host asks for the particles after each of them.
State collapsed(Backend& backend, Method method, int steps, bool looks = false) {
  fill(backend);
  const auto stepper = test::stepper_of(method, backend);
  for (int k = 0; k < steps; ++k) {
    stepper->step(2e-3);
    if (looks) {
      EXPECT_EQ(backend.fluid().size(), 216u);
    }
  }
  return state_of(backend);
}

// Many lists later: none came too late, and no sum was of another particle.
TEST_P(Device, MovesAFlowAsTheProcessorDoes) {
  for (const Method method : test::both_methods) {
    const auto device = make(collapsing()), cpu = make_backend(BackendKind::cpu, collapsing());
    const State expected = collapsed(*cpu, method, 100);
    const State state = collapsed(*device, method, 100);
    ASSERT_EQ(state.size(), expected.size());
    double moved = 0;
    for (const auto& [id, x] : expected) {
      moved = std::max(moved, norm(x.second));
      EXPECT_LT(norm(state.at(id).first - x.first), 2e-4 * 0.1);
    }
    EXPECT_GT(moved, 0.5);  // m/s
    EXPECT_GT(device->pass_times()["sort"].calls, 3u);
  }
}

// As a card with few particles, where several threads share each row of pairs.
TEST(SharedRows, MoveAFlowAsWholeOnesDo) {
  for (const Method method : test::both_methods) {
    test::DeviceOnHost whole(collapsing());
    const State expected = collapsed(whole, method, 60);
    for (const std::uint32_t shares : {2u, 8u, 32u}) {
      test::DeviceOnHost sharing(collapsing(), test::LateExecutor({.row_shares = shares}));
      for (const auto& [id, x] : collapsed(sharing, method, 60))
        EXPECT_LT(norm(expected.at(id).first - x.first), 2e-4 * 0.1) << shares;
    }
  }
}

TEST_P(Device, GivesTheSameBitsEachTimeWhetherOrNotTheHostLooks) {
  const auto first = make(collapsing()), again = make(collapsing()), seen = make(collapsing());
  const State expected = collapsed(*first, Method::fast, 30);
  EXPECT_EQ(collapsed(*again, Method::fast, 30), expected);
  EXPECT_EQ(collapsed(*seen, Method::fast, 30, true), expected);
}

TEST_P(Device, TakesChangesOfTheHostOver) {
  const auto backend = make(collapsing());
  fill(*backend);
  const auto stepper = test::stepper_of(Method::fast, *backend);
  stepper->step();
  // Far above all others, where it falls freely.
  add_particle(backend->fluid(), backend->model(), {0.3, 0.3, 5}, {0, 0, -1});
  backend->fluid().id.back() = 1000;
  EXPECT_TRUE(backend->neighbours_are_stale(0));
  const double t = stepper->time();
  stepper->step();
  const double dt = stepper->time() - t;
  ASSERT_EQ(backend->fluid().size(), 217u);
  const auto [position, velocity] = state_of(*backend).at(1000);
  EXPECT_NEAR(velocity.z, -1 - 9.81 * dt, 1e-5);  // the solve is in single precision
  EXPECT_NEAR(position.z, 5 + dt * velocity.z, 1e-12);
}

/// Takes two particles out, stops one and lets another fall from far above.
void change_some(Backend& backend) {
  const auto rows_of = [&](std::uint32_t a, std::uint32_t b) {
    ParticleRows rows;
    const std::span<const std::uint32_t> id = backend.places().id;
    for (std::uint32_t i = 0; i < id.size(); ++i)
      if (id[i] == a || id[i] == b) rows.push_back(i);
    return rows;
  };
  const Particles taken = backend.take_out(rows_of(17, 180));
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(taken.id[0] + taken.id[1], 197u);
  backend.change_rows(rows_of(40, 41), [&](Particles& some) {
    ASSERT_EQ(some.size(), 2u);
    some.velocity[some.id[0] == 40 ? 0 : 1] = {};
    add_particle(some, backend.model(), {0.3, 0.3, 5}, {0, 0, -1});
    some.id.back() = 1000;
  });
}

// Whether or not the host has asked for the fluid before.
TEST_P(Device, ChangesRowsAsTheHostDoes) {
  const auto seen = make(collapsing()), unseen = make(collapsing());
  const auto cpu = make_backend(BackendKind::cpu, collapsing());
  for (Backend* backend : {seen.get(), unseen.get(), cpu.get()}) {
    fill(*backend);
    const auto stepper = test::stepper_of(Method::fast, *backend);
    for (int k = 0; k < 20; ++k) stepper->step(2e-3);
    if (backend == seen.get()) {
      EXPECT_EQ(backend->fluid().size(), 216u);
    }
    change_some(*backend);
    EXPECT_TRUE(backend->neighbours_are_stale(0));
    EXPECT_EQ(backend->fluid_count(), 215u);
    EXPECT_EQ(backend->places().id.size(), 215u);
    EXPECT_EQ(backend->asleep_count(), 0u);
    for (int k = 0; k < 20; ++k) stepper->step(2e-3);
  }
  const State expected = state_of(*cpu), found = state_of(*unseen);
  EXPECT_EQ(state_of(*seen), found);
  ASSERT_EQ(found.size(), 215u);
  EXPECT_FALSE(found.contains(17) || found.contains(180));
  EXPECT_LT(found.at(1000).second.z, -1.3);
  for (const auto& [id, x] : found)
    EXPECT_LT(norm(expected.at(id).first - x.first), 2e-4 * 0.1) << id;
}

TEST_P(Device, WantsAnotherListOnceRowsHaveChanged) {
  const auto backend = make(collapsing());
  fill(*backend);
  for (const bool host_has_asked : {false, true}) {
    backend->find_neighbours();
    if (host_has_asked) {
      EXPECT_EQ(backend->fluid().size(), 216u);
    }
    EXPECT_FALSE(backend->neighbours_are_stale(0));
    backend->change_rows({3}, [](Particles& some) { some.velocity = {{1, 0, 0}}; });
    EXPECT_TRUE(backend->neighbours_are_stale(0));
  }
}

/// Takes the western half of the floor away and lays a row beside its eastern side.
BoundaryChange moved_floor(Backend& backend) {
  BoundaryChange change;
  const Particles& floor = backend.boundary();
  std::vector<std::uint32_t> gone;
  for (std::size_t k = 0; k < floor.size(); ++k)
    if (floor.position[k].x < 0.3) gone.push_back(floor.id[k]);
  std::ranges::sort(gone);
  for (const std::uint32_t id : gone) {
    if (!change.dropped.empty() && id == change.dropped.back().first + change.dropped.back().count)
      ++change.dropped.back().count;
    else
      change.dropped.push_back({id, 1});
  }
  test::add_block(change.made, backend.model(), {12, 13, -6, 12, -3, 0});
  for (std::uint32_t& id : change.made.id) id += 10000;
  return change;
}

// Where the arrays are makes no difference to what becomes of them, whether or not the host has
// asked for the boundary before.
TEST_P(Device, ChangesTheBoundaryAsTheHostDoes) {
  const auto seen = make(collapsing()), unseen = make(collapsing());
  const auto cpu = make_backend(BackendKind::cpu, collapsing());
  for (Backend* backend : {seen.get(), unseen.get(), cpu.get()}) {
    collapsed(*backend, Method::fast, 20);
    const BoundaryChange change = moved_floor(*backend);
    EXPECT_GT(change.dropped.size(), 1u);
    // The host's copy is out of date after a step, unless the host asks for it.
    const auto stepper = test::stepper_of(Method::fast, *backend);
    stepper->step(1e-3);
    if (backend == seen.get()) {
      EXPECT_EQ(backend->boundary().size(), 18u * 18 * 3);
    }
    backend->change_boundary(change);
    EXPECT_TRUE(backend->neighbours_are_stale(0));
    EXPECT_EQ(backend->boundary_count(), 18u * 18 * 3 / 2 + 18u * 3);
    for (int k = 0; k < 20; ++k) stepper->step(2e-3);
  }
  const State expected = state_of(*cpu);
  EXPECT_EQ(state_of(*seen), state_of(*unseen));
  for (const auto& [id, x] : state_of(*unseen))
    EXPECT_LT(norm(expected.at(id).first - x.first), 2e-4 * 0.1);
  std::map<std::uint32_t, std::pair<Vec3d, double>> floor;
  for (std::size_t k = 0; k < cpu->boundary().size(); ++k)
    floor[cpu->boundary().id[k]] = {cpu->boundary().position[k], cpu->boundary().mass[k]};
  const Particles& boundary = unseen->boundary();
  ASSERT_EQ(boundary.size(), floor.size());
  for (std::size_t k = 0; k < boundary.size(); ++k)
    EXPECT_EQ(std::pair(boundary.position[k], boundary.mass[k]), floor.at(boundary.id[k]));
}

// Spacing 1, h = 1.5, list radius 2.2 h = 3.3: in a row of particles along x each lists three to
// either side. Five of fluid, then two of boundary, which list fluid only.
TEST_P(Device, CountsTheListedPairs) {
  const FlowModel model = test::plain_model(1, 10, 1);
  const auto backend = make(model);
  for (int i = 0; i < 5; ++i) add_particle(backend->fluid(), model, {1.0 * i, 0, 0});
  for (int i = 5; i < 7; ++i) add_particle(backend->boundary(), model, {1.0 * i, 0, 0});
  backend->find_neighbours();
  backend->pressure();
  backend->strain_and_density_rates();
  backend->stress();
  backend->momentum();
  EXPECT_EQ(backend->pass_times()["force sweep"].pairs, 3u + 4 + 5 + 6 + 5);
  EXPECT_EQ(backend->pass_times()["motion sweep"].pairs, 23u + 3 + 2);
}

// The skin is 0.2 h = 0.03 m. All together may move by that, two against each other by it in all.
TEST_P(Device, KeepsAListWhileNoPairCanHaveComeIn) {
  const auto is_stale = [&](double left, double right, double distance, bool is_periodic) {
    FlowModel model = test::plain_model(0.1, 10, 0);
    model.gravity = {};
    if (is_periodic) model.periodic.period[0] = {50, 0, 0};
    const auto backend = make(model);
    for (const bool is_right : {false, true}) {
      const double speed = is_right ? right : left;
      add_particle(backend->fluid(), model, {is_right ? distance : 0.0, 0, 0}, {speed, 0, 0});
    }
    backend->find_neighbours();
    backend->pressure();
    backend->wall_pressure();
    backend->near_forces();
    backend->wall_resistance();
    EXPECT_TRUE(test::advance_velocity(*backend, 1, 1e-9, 10).converged);
    backend->near_motion();
    backend->advance_state();
    return backend->neighbours_are_stale(0);
  };
  for (const bool is_periodic : {false, true}) {
    EXPECT_FALSE(is_stale(0.014, -0.014, 0.5, is_periodic));
    EXPECT_TRUE(is_stale(0.016, -0.016, 0.5, is_periodic));
    EXPECT_FALSE(is_stale(0.029, 0.029, 0.5, is_periodic));
    EXPECT_TRUE(is_stale(0.031, 0.031, 0.5, is_periodic));
  }
  // Columns are 0.33 m wide: 0.98 m are the most that two in three of them can be apart.
  EXPECT_TRUE(is_stale(0.02, -0.02, 0.98, false));
  EXPECT_FALSE(is_stale(0.02, -0.02, 1, false));
  EXPECT_TRUE(is_stale(0.02, -0.02, 1, true));
}

TEST_P(Device, RunsWithoutGroundAndWithoutFluid) {
  for (const Method method : test::both_methods) {
    const auto empty = make(collapsing());
    test::stepper_of(method, *empty)->step(1e-3);
    EXPECT_TRUE(empty->health().is_finite);
    const auto free = make(collapsing());
    test::add_block(free->fluid(), free->model(), {0, 3, 0, 3, 0, 3});
    const auto stepper = test::stepper_of(method, *free);
    stepper->advance_to(0.01);
    for (const Vec3d& v : free->fluid().velocity) EXPECT_NEAR(v.z, -9.81 * 0.01, 1e-6);
  }
}

TEST_P(Device, SaysThatTheStateIsNoLongerFinite) {
  const auto backend = make(collapsing());
  fill(*backend);
  backend->find_neighbours();
  EXPECT_TRUE(backend->health().is_finite);
  backend->fluid().velocity[7].y = std::nan("");
  backend->find_neighbours();
  EXPECT_FALSE(backend->health().is_finite);
}

}  // namespace
}  // namespace sabo
