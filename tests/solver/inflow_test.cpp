#include "solver/inflow.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <tuple>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "solver/domain.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

/// A trough along x, 2 m wide and level, its banks 5 m high; vertices every metre.
Surface trough() {
  Raster bed(Grid{21, 11, -10.5, 5.5, 1, 1}, 0.0);
  for (int row = 0; row < 11; ++row)
    for (int column = 0; column < 21; ++column)
      if (std::abs(bed.grid.y_of(row)) > 1) bed.at(column, row) = 5;
  return Surface(bed);
}

/// 4 m3/s at 2 m/s through the 2 m: 1 m deep, 4 x 2 particles of half a metre in a layer.
InflowPlan plan_over(const Surface& surface) {
  const Polyline line{{{0, -1, 0}, {0, 1, 0}}, false};
  return {"apex",
          line,
          InflowSection(surface, line, false, 0.5, 2),
          {{0, 100}, {4, 4}, {2, 2}},
          1,
          0.5,
          2,
          1000,
          9.81};
}

/// Moves what is driven over steps of 0.05 s, as a stepper would.
class Channel {
 public:
  explicit Channel(const InflowPlan& plan) : inflow_(plan, 1) {}

  void run(double duration) {
    constexpr double dt = 0.05;
    for (const double end = time_ + duration; time_ < end - dt / 2; time_ += dt) {
      for (std::size_t i = 0; i < fluid.size(); ++i)
        if (fluid.driven[i] != 0) fluid.position[i] += dt * fluid.velocity[i];
      inflow_.advance(fluid, Tait{1000, 50}, time_ + dt, dt, next_id_);
    }
  }

  Particles fluid;

 private:
  Inflow inflow_;
  double time_ = 0;
  std::uint32_t next_id_ = 0;
};

TEST(InflowLayers, ComeASpacingApartWithThePressureOfTheirDepth) {
  const Surface surface = trough();
  const InflowPlan plan = plan_over(surface);
  Channel channel(plan);
  channel.run(1);  // 2 m, four layers
  const Particles& fluid = channel.fluid;
  ASSERT_EQ(fluid.size(), 4u * 8);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d& x = fluid.position[i];
    EXPECT_NEAR(std::remainder(x.x - fluid.position[0].x, 0.5), 0, 1e-9);
    EXPECT_EQ(fluid.velocity[i], (Vec3d{2, 0, 0}));
    EXPECT_EQ(fluid.driven[i], 1);
    // 8 particles fill the section to 1 m.
    EXPECT_NEAR((Tait{1000, 50}.pressure(fluid.density[i])), 9810 * (1 - x.z), 1);
    EXPECT_EQ(fluid.mass[i], 125);
  }
}

TEST(InflowLayers, AreFreeBeyondTheirReach) {
  const Surface surface = trough();
  const InflowPlan plan = plan_over(surface);
  Channel channel(plan);
  channel.run(3);
  for (std::size_t i = 0; i < channel.fluid.size(); ++i)
    EXPECT_EQ(channel.fluid.driven[i] == 0, channel.fluid.position[i].x > 2) << i;
  EXPECT_GT(std::ranges::count(channel.fluid.driven, 0), 0);
}

TEST(InflowLayers, TakeTheFreePlacesAboveWhatHasBackedUp) {
  const Surface surface = trough();
  const InflowPlan plan = plan_over(surface);
  Channel empty(plan), blocked(plan);
  blocked.fluid.resize(1);
  blocked.fluid.position[0] = {0, -0.25, 0.25};
  blocked.fluid.mass[0] = 125;
  blocked.fluid.density[0] = 1000;
  empty.run(0.3);
  blocked.run(0.3);
  ASSERT_EQ(empty.fluid.size(), 8u);
  ASSERT_EQ(blocked.fluid.size(), 9u);
  for (std::size_t i = 1; i < blocked.fluid.size(); ++i)
    EXPECT_GT(norm(blocked.fluid.position[i] - blocked.fluid.position[0]), 0.35);
  const auto highest = [](const Particles& fluid) {
    return std::ranges::max(fluid.position, {}, &Vec3d::z).z;
  };
  EXPECT_NEAR(highest(empty.fluid), 0.75, 1e-12);
  EXPECT_NEAR(highest(blocked.fluid), 1.25, 1e-12);
}

using Driven = test::OnBackend;

INSTANTIATE_TEST_SUITE_P(On, Driven, testing::ValuesIn(test::all_backends), test::name_of_backend);

/// The trough with a bed that rises and falls along it.
Surface wavy_trough() {
  Raster bed(Grid{21, 11, -10.5, 5.5, 1, 1}, 0.0);
  for (int row = 0; row < 11; ++row)
    for (int column = 0; column < 21; ++column) {
      const bool is_bank = std::abs(bed.grid.y_of(row)) > 1;
      bed.at(column, row) = is_bank ? 5 : 0.3 * std::sin(1.3 * bed.grid.x_of(column));
    }
  return Surface(bed);
}

TEST_P(Driven, ParticlesKeepTheirHeightAboveTheBed) {
  const Surface surface = wavy_trough();
  const std::vector<InflowPlan> plans{plan_over(surface)};
  for (const Method method : test::both_methods) {
    auto backend = test::make_backend(GetParam(), test::plain_model(0.5, 40, 500));
    Ground ground(surface, {}, {0.5, backend->model().wall_layers(), 1000});
    Domain domain(ground, plans, 0);
    auto stepper = test::stepper_of(method, *backend, &domain);
    stepper->advance_to(0.8, 5e-3);
    const Particles& fluid = backend->fluid();
    std::size_t driven = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      if (fluid.driven[i] == 0) continue;
      ++driven;
      // They came 1/4 m, 3/4 m, ... above it.
      const double height = fluid.position[i].z - plans[0].section.bed(fluid.position[i]);
      EXPECT_NEAR(std::remainder(height - 0.25, 0.5), 0, 1e-9) << word_of(method);
      EXPECT_NEAR(fluid.velocity[i].z / fluid.velocity[i].x,
                  plans[0].section.rise_at(fluid.position[i]), 1e-12);
    }
    EXPECT_GT(driven, 8u);
  }
}

// Spacings are half a metre, and a layer comes up to one beyond the line: what is farther than 0.85
// m from both lines is not in the way.
TEST_P(Driven, AndThoseInTheWayAreAllThatALayerHasToSee) {
  const Surface surface = trough();
  InflowPlan second = plan_over(surface);
  second.line = {{{5, -1, 0}, {5, 1, 0}}, false};
  second.section = InflowSection(surface, second.line, false, 0.5, 2);
  const std::vector<InflowPlan> plans{plan_over(surface), second};
  Ground ground(surface, {}, {0.5, 3, 1000});
  const Domain domain(ground, plans, 0);
  auto backend = test::make_backend(GetParam(), test::plain_model(0.5, 40, 500));
  const auto add = [&](double x, std::uint16_t driven) {
    add_particle(backend->fluid(), backend->model(), {x, 0, 0.25});
    backend->fluid().id.back() = static_cast<std::uint32_t>(backend->fluid().size() - 1);
    backend->fluid().driven.back() = driven;
  };
  for (const double x : {2.5, 0.8, -3.0, 5.8, -0.8, 0.9, 4.1}) add(x, 0);
  for (const double x : {0.7, 2.0}) add(x, 1);
  backend->find_neighbours();
  const ParticleRows rows = domain.rows_at_inflows(*backend);
  std::set<std::uint32_t> found;
  for (const std::uint32_t row : rows) found.insert(backend->places().id[row]);
  EXPECT_EQ(found, (std::set<std::uint32_t>{1, 3, 4, 7, 8}));
  EXPECT_EQ(rows.size(), 5u);
  EXPECT_TRUE(std::ranges::is_sorted(rows));
}

// Wherever the flow is, layers come and go free as they do on the host.
TEST_P(Driven, ParticlesComeAndGoFreeAsOnTheHost) {
  const Surface surface = wavy_trough();
  const std::vector<InflowPlan> plans{plan_over(surface)};
  const auto numbers = [&](test::On on) {
    auto backend = test::make_backend(on, test::plain_model(0.5, 40, 500));
    Ground ground(surface, {}, {0.5, backend->model().wall_layers(), 1000});
    Domain domain(ground, plans, 0);
    auto stepper = test::stepper_of(Method::fast, *backend, &domain);
    stepper->advance_to(2.05, 2.5e-3);
    const Particles& fluid = backend->fluid();
    std::set<std::uint32_t> driven;
    for (std::size_t i = 0; i < fluid.size(); ++i)
      if (fluid.driven[i] != 0) driven.insert(fluid.id[i]);
    const auto ids = [](const Particles& of) { return std::set(of.id.begin(), of.id.end()); };
    return std::tuple(ids(domain.take_freed()), driven, ids(domain.take_entered()), fluid.size());
  };
  const bool is_reference = GetParam() == test::On::reference;
  const auto expected = numbers(is_reference ? test::On::cpu : test::On::reference);
  EXPECT_GT(std::get<0>(expected).size(), 8u);
  EXPECT_EQ(numbers(GetParam()), expected);
}

/// A cube whose half is driven sideways; the other half is at rest.
std::unique_ptr<Backend> half_driven_cube(test::On on) {
  FlowModel model = test::plain_model(0.1, 20, 1000);
  model.gravity = {};
  auto backend = test::make_backend(on, model);
  Particles& fluid = backend->fluid();
  test::add_block(fluid, model, {0, 6, 0, 6, 0, 6});
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    if (fluid.position[i].x > 0.3) continue;
    fluid.driven[i] = 1;
    fluid.velocity[i] = {0, 1, 0};
  }
  return backend;
}

TEST_P(Driven, ParticlesKeepTheirVelocityAndDragTheOthers) {
  for (const Method method : test::both_methods) {
    auto backend = half_driven_cube(GetParam());
    const Particles start = backend->fluid();
    auto stepper = test::stepper_of(method, *backend);
    stepper->step();
    const double time = stepper->time();
    const Particles& fluid = backend->fluid();
    ASSERT_EQ(fluid.size(), start.size());
    double slowest = 1, fastest = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      if (fluid.driven[i] != 0) {
        EXPECT_EQ(fluid.velocity[i], (Vec3d{0, 1, 0}));
        EXPECT_NEAR(norm(fluid.position[i] - start.position[fluid.id[i]] - Vec3d{0, time, 0}), 0,
                    1e-12);
        EXPECT_EQ(fluid.density[i], 1000);
      } else {
        slowest = std::min(slowest, fluid.velocity[i].y);
        fastest = std::max(fastest, fluid.velocity[i].y);
      }
    }
    EXPECT_GT(fastest, 0.005) << word_of(method);
    EXPECT_GT(slowest, -1e-3) << word_of(method);
    EXPECT_LT(fastest, 1) << word_of(method);
  }
}

}  // namespace
}  // namespace sabo
