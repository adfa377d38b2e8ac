#include "terrain/body.hpp"

#include <cmath>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "terrain/ground.hpp"
#include "terrain/release.hpp"

// Flows in tanks and around bodies, particles of 0.1 m.

namespace sabo {
namespace {

constexpr double dp = 0.1;
constexpr double reach = 3 * dp;

Surface level_floor() { return Surface(Raster(Grid{21, 21, -5.25, 5.25, 0.5, 0.5}, 0.0)); }

struct World {
  FlowModel model;
  Surface surface = level_floor();
  Ground ground;
  Domain domain;
  std::unique_ptr<Backend> backend;

  World(const FlowModel& m, const Bounds& water, const std::vector<Body>& bodies)
      : model(m),
        ground(surface, {}, {dp, 3, model.state.rho0}, bodies),
        domain(ground),
        backend(make_backend(BackendKind::cpu, model)) {
    backend->fluid() = released_box(surface, water, bodies, {dp, model.state.rho0, {}});
    make_hydrostatic(*backend, water.high.z);
  }
};

/// An open tank as the mesh of its walls and floor, turned and above the ground.
Body mesh_tank(const UprightBox& inside) {
  return {"tank", tank_mesh(inside, reach, true), FlowSide::outside, reach};
}

/// A closed one as the mesh of its inside.
Body mesh_hollow(const UprightBox& inside) {
  return {"hollow", box_mesh(inside), FlowSide::inside, reach};
}

void expect_rest(Method method, const Body& tank, const Bounds& water) {
  FlowModel model = test::plain_model(dp, 25, 5);
  model.diffusion_form = DiffusionForm::fourtakas;  // the other one is not for rest
  World world(model, water, {tank});
  const std::size_t count = world.backend->fluid().size();
  const auto stepper = test::stepper_of(method, *world.backend, &world.domain);
  stepper->advance_to(2);
  const Particles& fluid = world.backend->fluid();
  EXPECT_EQ(fluid.size(), count);
  EXPECT_EQ(world.domain.put_back_count(), 0u);
  double difference = 0, weight = 0, top = water.low.z;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    EXPECT_FALSE(world.ground.is_solid(fluid.position[i]));
    const double expected = 1000 * 9.81 * (water.high.z - fluid.position[i].z);
    difference += std::abs(fluid.pressure[i] - expected);
    weight += expected;
    top = std::max(top, fluid.position[i].z);
  }
  EXPECT_LT(difference / weight, 0.05) << word_of(method);
  EXPECT_NEAR(top, water.high.z - dp / 2, dp / 4) << word_of(method);
}

TEST(Tank, FromAMeshHoldsItsPressure) {
  const Bounds water{{-0.4, -0.3, 1}, {0.4, 0.3, 1.6}};
  for (const Method method : test::both_methods) {
    expect_rest(method, mesh_tank({{-0.4, -0.3, 1}, {0.4, 0.3, 1.9}, {}, 0}), water);
    expect_rest(method, mesh_hollow({{-0.4, -0.3, 1}, {0.4, 0.3, 1.9}, {}, 0}), water);
  }
}

// The lattice of the fluid meets walls of irregular particles.
TEST(Tank, InARoundHollowWaterStaysInside) {
  const Body bowl("bowl", test::sphere_mesh({0, 0, 1.2}, 0.6, 16, 24), FlowSide::inside, reach);
  for (const Method method : test::both_methods) {
    World world(test::plain_model(dp, 25, 5), {{-0.6, -0.6, 0.6}, {0.6, 0.6, 1.2}}, {bowl});
    std::vector<std::uint32_t> inside;
    for (std::uint32_t i = 0; i < world.backend->fluid().size(); ++i)
      if (norm(world.backend->fluid().position[i] - Vec3d{0, 0, 1.2}) < 0.6) inside.push_back(i);
    world.backend->fluid().permute(inside);
    const std::size_t count = inside.size();
    EXPECT_GT(count, 300u);
    const auto stepper = test::stepper_of(method, *world.backend, &world.domain);
    while (stepper->time() < 1) stepper->step();
    const Particles& fluid = world.backend->fluid();
    EXPECT_EQ(fluid.size(), count);
    EXPECT_EQ(world.domain.put_back_count(), 0u);
    for (const Vec3d& x : fluid.position) EXPECT_LT(norm(x - Vec3d{0, 0, 1.2}), 0.6);
  }
}

// Water that is thrown at a box and a ball on the floor, with walls that hold nothing back. Impacts
// press particles a little into a wall; beyond a tenth of a spacing they are put back.
TEST(Obstacle, IsNeverPenetrated) {
  const UprightBox block{{-0.2, -0.2, 0}, {0.2, 0.2, 0.4}, {}, 0.6};
  const Body box("box", box_mesh(block), FlowSide::outside, reach, {block});
  const Body ball("ball", test::sphere_mesh({0.9, 0, 0.25}, 0.3, 16, 24), FlowSide::outside, reach);
  for (const Method method : test::both_methods) {
    FlowModel model = test::plain_model(dp, 40, 1);
    model.wall = Slip{};
    World world(model, {{-1.3, -0.4, 0}, {-0.5, 0.4, 0.8}}, {box, ball});
    for (Vec3d& v : world.backend->fluid().velocity) v = {2, 0, 0};
    const auto stepper = test::stepper_of(method, *world.backend, &world.domain);
    bool has_passed = false;
    while (stepper->time() < 0.8) {
      stepper->step();
      for (const Vec3d& x : world.backend->fluid().position) {
        has_passed = has_passed || x.x > 1.3;
        if (!world.ground.is_solid(x)) continue;
        for (const Body* body : {&box, &ball}) {
          if (body->contains(x)) {
            EXPECT_LT(body->distance().nearest(x, 1)->distance, 0.25 * dp) << word_of(method);
          }
        }
      }
    }
    EXPECT_TRUE(has_passed) << word_of(method);
    EXPECT_LT(world.domain.put_back_count(), 60u) << word_of(method);
  }
}

}  // namespace
}  // namespace sabo
