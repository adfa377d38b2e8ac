#include <cmath>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "backend/body_load_sum.hpp"

namespace sabo {
namespace {

using test::g;
using test::plain_model;

FlowModel water(double spacing, double depth) {
  FlowModel model = plain_model(spacing, 10 * std::sqrt(g * depth), 1e-3);
  model.diffusion_form = DiffusionForm::fourtakas;
  model.boundary_pressure = BoundaryPressure::extrapolated;
  model.viscous_operator = ViscousOperator::morris;
  model.artificial_viscosity = 0.05;
  return model;
}

Vec3d momentum(const Particles& fluid) {
  Vec3d sum;
  for (std::size_t i = 0; i < fluid.size(); ++i) sum += fluid.mass[i] * fluid.velocity[i];
  return sum;
}

class BodyLoads : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Both, BodyLoads, testing::ValuesIn(test::both_methods),
                         [](const auto& method) { return std::string(word_of(method.param)); });

/// A viscous block falls, sliding, on a floor and against a post, which are bodies 1 and 2.
void expect_momentum_kept(Method method, test::On kind, FlowModel model) {
  const double tolerance = kind == test::On::reference ? 1e-8 : 1e-5;
  auto backend = test::make_backend(kind, model);
  const double dp = model.spacing;
  add_box(backend->fluid(), model, {{0, 0, 0}, {8 * dp, 6 * dp, 6 * dp}});
  for (Vec3d& v : backend->fluid().velocity) v = {1, 0.3, -0.2};
  Particles& walls = backend->boundary();
  add_box(walls, model, {{-3 * dp, -6 * dp, -3 * dp}, {14 * dp, 12 * dp, 0}}, 1);
  add_box(walls, model, {{8 * dp, dp, 0}, {11 * dp, 4 * dp, 8 * dp}}, 2);
  const Vec3d before = momentum(backend->fluid());
  NumericsCase numerics = default_numerics(method);
  numerics.viscous_tolerance = 1e-9;
  numerics.viscous_iterations = 1000;
  const auto stepper = make_stepper(numerics, *backend, nullptr);
  for (int step = 0; step < 25; ++step) stepper->step();

  ASSERT_EQ(stepper->body_impulses().size(), 2u);
  const Vec3d floor = stepper->body_impulses()[0].force, post = stepper->body_impulses()[1].force;
  const Vec3d weight = stepper->time() * test::mass_of(backend->fluid()) * model.gravity;
  const Vec3d lost = weight + before - momentum(backend->fluid());
  EXPECT_LT(norm(floor + post - lost), tolerance * norm(lost));
  EXPECT_LT(floor.z, -0.2 * norm(lost));  // it carries
  EXPECT_GT(floor.x, 0.02 * norm(lost));  // and rubs
  EXPECT_GT(post.x, 0.1 * norm(lost));
}

// To the tolerance of the implicit solve, and to rounding in the sums of pairs.
TEST_P(BodyLoads, TakeTheMomentumThatTheFluidLoses) {
  FlowModel model = water(0.05, 0.5);
  model.rheology = Cross{2, 100, 1};
  model.yield = {10, 20, 0};
  model.wall = Voellmy{{5, 0.2}, 300};
  for (const test::On kind : test::backends()) expect_momentum_kept(GetParam(), kind, model);
  model.viscous_operator = ViscousOperator::nested;
  model.boundary_stress = BoundaryStress::own;
  model.wall = NoSlip{};
  for (const test::On kind : test::backends()) expect_momentum_kept(GetParam(), kind, model);
}

// Ground and bodies are there beside the flow only: a body that it has left bears nothing.
TEST_P(BodyLoads, AreZeroOnceNoParticleOfTheBodyIsThere) {
  const FlowModel model = water(0.1, 0.5);
  for (const test::On kind : test::backends()) {
    auto backend = test::make_backend(kind, model);
    add_box(backend->fluid(), model, {{0, 0, 0}, {0.5, 0.5, 0.5}});
    add_box(backend->boundary(), model, {{-0.3, -0.3, -0.3}, {0.8, 0.8, 0}}, 1);
    const auto stepper = test::stepper_of(GetParam(), *backend);
    for (int step = 0; step < 5; ++step) stepper->step();
    EXPECT_LT(backend->body_loads().at(0).force.z, 0);
    EXPECT_FALSE(backend->body_forces().empty());
    backend->change_boundary({{{0, static_cast<std::uint32_t>(backend->boundary_count())}}, {}});
    backend->find_neighbours();
    stepper->step();
    EXPECT_EQ(norm(backend->body_loads().at(0).force), 0);
    EXPECT_TRUE(backend->body_forces().empty());
  }
}

// Mean load over the time from `settle` to twice that.
std::vector<BodyLoad> mean_loads(Method method, Backend& backend, double settle) {
  const auto stepper = test::stepper_of(method, backend);
  stepper->advance_to(settle);
  std::vector<BodyLoad> loads = stepper->body_impulses();
  stepper->advance_to(2 * settle);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    loads[k] += -1.0 * stepper->body_impulses()[k];
    loads[k] = (-1 / settle) * loads[k];
  }
  return loads;
}

// Water of the depth H between two walls: rho g H^2/2 on each, H/3 above the floor. The walls' feet
// beside the floor are theirs.
TEST_P(BodyLoads, OfAWallAreThoseOfStillWater) {
  constexpr double depth = 1, length = 1;
  for (const test::On kind : test::backends()) {
    const bool is_fine = kind == test::On::cpu || kind == test::On::cuda;
    const int cells = is_fine ? 40 : 10;
    FlowModel model = water(depth / cells, depth);
    model.dimension = 2;
    auto backend = test::make_backend(kind, model);
    const double t = 3 * model.spacing;
    add_still_box(backend->fluid(), model, {{}, {length, 0, depth}});
    Particles& walls = backend->boundary();
    add_box(walls, model, {{0, 0, -t}, {length, 0, 0}}, 1);
    add_box(walls, model, {{-t, 0, -t}, {0, 0, 1.2 * depth}}, 2);
    add_box(walls, model, {{length, 0, -t}, {length + t, 0, 1.2 * depth}}, 3);
    const auto loads = mean_loads(GetParam(), *backend, is_fine ? 1 : 0.2);
    ASSERT_EQ(loads.size(), 3u);
    const double thrust = 1000 * g * depth * depth / 2, weight = 1000 * g * depth * length;
    // Feet take a part of the weight; the walls' sums know the depth to about half a spacing.
    const double share = is_fine ? 0.03 : 0.1;
    EXPECT_NEAR(loads[0].force.z + loads[1].force.z + loads[2].force.z, -weight, 0.01 * weight);
    EXPECT_NEAR(loads[1].force.x, -thrust, share * thrust);
    EXPECT_NEAR(loads[2].force.x, thrust, share * thrust);
    // The moment about the toe turns +z into +x: +y.
    const Vec3d toe{length, 0, 0};
    const double lever = thrust * depth / 3;
    EXPECT_NEAR(loads[2].moment_about(toe).y, lever, 3 * share * lever);
  }
}

// A box held in still water is pushed up by the weight of the water it takes the place of.
TEST_P(BodyLoads, OfASubmergedBoxAreItsBuoyancy) {
  constexpr double depth = 1;
  const int cells = 40;
  FlowModel model = water(depth / cells, depth);
  model.dimension = 2;
  auto backend = make_backend(BackendKind::cpu, model);
  const double dp = model.spacing, side = 12 * dp;
  const Box box{{0.5 - side / 2, 0, 0.5 - side / 2}, {0.5 + side / 2, 0, 0.5 + side / 2}};
  add_still_box(backend->fluid(), model, {{}, {1, 0, depth}});
  std::vector<std::uint32_t> outside;
  for (std::uint32_t i = 0; i < backend->fluid().size(); ++i) {
    const Vec3d& x = backend->fluid().position[i];
    if (x.x < box.low.x || x.x > box.high.x || x.z < box.low.z || x.z > box.high.z)
      outside.push_back(i);
  }
  backend->fluid().permute(outside);
  Tank{{{}, {1, 0, 1.2 * depth}}}.add_to(backend->boundary(), model);
  add_box(backend->boundary(), model, box, 1);
  const auto loads = mean_loads(GetParam(), *backend, 1);
  const double buoyancy = 1000 * g * side * side;
  EXPECT_NEAR(loads[0].force.z, buoyancy, 0.03 * buoyancy);
  EXPECT_NEAR(loads[0].force.x, 0, 0.02 * buoyancy);
  EXPECT_NEAR(loads[0].moment_about({0.5, 0, 0.5}).y, 0, 0.02 * buoyancy * side);
}

TEST_P(BodyLoads, HaveTheSameBitsForAnyNumberOfThreads) {
  std::vector<BodyLoad> first;
  for (const int threads : {1, 3}) {
    FlowModel model = water(0.05, 0.5);
    model.threads = threads;
    auto backend = make_backend(BackendKind::cpu, model);
    add_box(backend->fluid(), model, {{0, 0, 0}, {0.5, 0.5, 0.5}});
    add_box(backend->boundary(), model, {{-0.2, -0.2, -0.15}, {0.7, 0.7, 0}}, 1);
    const auto stepper = test::stepper_of(GetParam(), *backend);
    for (int step = 0; step < 20; ++step) stepper->step();
    const std::vector<BodyLoad>& impulses = stepper->body_impulses();
    if (first.empty()) first = impulses;
    ASSERT_EQ(impulses.size(), 1u);
    EXPECT_EQ(norm(impulses[0].force - first[0].force), 0);
    EXPECT_EQ(norm(impulses[0].moment - first[0].moment), 0);
    EXPECT_LT(impulses[0].force.z, 0);
  }
}

TEST(BodyLoad, IsNoneWithoutBodies) {
  const FlowModel model = water(0.1, 0.5);
  auto backend = make_backend(BackendKind::cpu, model);
  add_box(backend->fluid(), model, {{}, {0.3, 0.3, 0.3}});
  const auto stepper = test::stepper_of(Method::fast, *backend);
  stepper->step();
  EXPECT_TRUE(stepper->body_impulses().empty());
  for (const PassTime& pass : backend->pass_times().passes()) EXPECT_NE(pass.name, "bodies");
}

// A wall from 2 m up, and the ground under it, in which the kernel reaches a metre deep.
TEST(BodyLoadSum, TakesOfAFoundationWhatPushesAlongTheGround) {
  BodyLoadSum sum;
  sum.list({{1, false, {5, 0, 3}, {}}, {1, true, {6, 0, 1}, {}}},
           [](double x, double) { return x / 3; });
  sum.sum(std::vector<Vec3d>{{7, 8, 9}, {10, 0, -10}});
  ASSERT_EQ(sum.loads().size(), 1u);
  EXPECT_EQ(sum.loads()[0].force, (Vec3d{17, 8, 9}));
  EXPECT_EQ(sum.loads()[0].moment,
            cross(Vec3d{5, 0, 3}, Vec3d{7, 8, 9}) + cross(Vec3d{6, 0, 2}, Vec3d{10, 0, 0}));
  EXPECT_EQ(sum.forces()[1].position.z, 2);
}

// A load on a bar along x, 2 m from the origin: about its own place it turns nothing.
TEST(BodyLoad, TurnsAboutAnyPoint) {
  const Vec3d place{2, 0, 0}, force{0, 0, 3};
  const BodyLoad load{force, cross(place, force)};
  EXPECT_EQ(load.moment.y, -6);
  EXPECT_EQ(norm(load.moment_about(place)), 0);
  EXPECT_EQ(load.moment_about({3, 0, 0}).y, 3);
}

}  // namespace
}  // namespace sabo
