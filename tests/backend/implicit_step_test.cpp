#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "support/backends.hpp"
#include "support/clouds.hpp"
#include "support/ground.hpp"
#include "support/scenes.hpp"
#include "support/viscous_step.hpp"
#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.hpp"
#include "backend/reference/reference_backend.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

using test::add_particle;
using test::advance_velocity;
using test::kinetic_energy_of;
using test::OpenedReference;
using test::prepare;
using test::set_viscosity;
using test::viscous;

Vec3d momentum_of(const Particles& fluid) {
  Vec3d sum;
  for (std::size_t i = 0; i < fluid.size(); ++i) sum += fluid.mass[i] * fluid.velocity[i];
  return sum;
}

// A block slides over a level bed of 8 x 8 spacings under a pressure of 3000 Pa: the forces of its
// particles add up to the stress of the law times the area of the bed.
TEST(WallResistance, AddsUpToTheStressOverTheBed) {
  const double p = 3000, speed = 2;
  const Coulomb friction{40, 0.3};
  const double turbulent = 1000 * 9.81 * speed * speed / 300;
  const struct {
    WallShear wall;
    double stress;
  } cases[] = {{friction, 40 + 0.3 * p}, {Voellmy{friction, 300}, 40 + 0.3 * p + turbulent}};
  for (const auto& c : cases) {
    FlowModel model = viscous(1e6);
    model.gravity = {9.81, 0, 0};  // along the bed: no weight to carry down to it
    model.wall = c.wall;
    model.periodic.period = {Vec3d{0.8, 0, 0}, Vec3d{0, 0.8, 0}, Vec3d{}};
    const auto backend = std::make_unique<OpenedReference>(model);
    test::add_block(backend->fluid(), model, {0, 8, 0, 8, 0, 6});
    test::add_block(backend->boundary(), model, {0, 8, 0, 8, -3, 0});
    for (std::size_t i = 0; i < backend->fluid().size(); ++i) {
      backend->fluid().density[i] = model.state.density(p);
      backend->fluid().velocity[i] = {speed, 0, 0};
    }
    prepare(*backend);
    double force = 0;
    for (const double drag : backend->wall_drag_) force += drag * speed;
    // Density at 3000 Pa is 0.7 % above the reference.
    EXPECT_NEAR(force / (0.64 * c.stress), 1, 0.01);
  }
}

// Six layers that move as one: over a wall on which they slide nothing is sheared, over one that
// holds them with a quarter of what sticking takes a quarter of what that shears. At rest all the
// viscosity there is: 1 Pa s.
TEST(WallGrip, ShearsTheFlowByAsMuchAsItIsHeld) {
  constexpr double speed = 1;
  const auto shear_rate = [](test::On kind, const WallShear& wall) {
    FlowModel model = viscous(1);
    model.wall = wall;
    model.periodic.period = {Vec3d{0.8, 0, 0}, Vec3d{0, 0.8, 0}, Vec3d{}};
    const auto backend = test::make_backend(kind, model);
    test::add_block(backend->fluid(), model, {0, 8, 0, 8, 0, 6});
    test::add_block(backend->boundary(), model, {0, 8, 0, 8, -3, 0});
    for (Vec3d& v : backend->fluid().velocity) v = {speed, 0, 0};
    prepare(*backend);
    const double dt = 1e-9;
    advance_velocity(*backend, dt, 1e-9, 10);
    backend->near_motion();
    backend->advance_state();
    double greatest = 0;
    for (const double rate : backend->fluid().shear_rate) greatest = std::max(greatest, rate);
    return greatest;
  };
  for (const test::On kind : test::backends()) {
    const double sticks = shear_rate(kind, NoSlip{});
    EXPECT_GT(sticks, 0.5 * speed / 0.1);
    EXPECT_LT(shear_rate(kind, Slip{}), 1e-5 * sticks);
    // Sticking takes 1 Pa s over half a spacing, 20 Pa.
    EXPECT_NEAR(shear_rate(kind, Coulomb{5, 0}), 0.25 * sticks, 0.01 * sticks);
  }
}

/// Sum of 2 V |grad S| over the particles above a bed.
double bed_area(const OpenedReference& backend, const Particles& fluid, const auto& counts) {
  double area = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i)
    if (counts(fluid.position[i]))
      area += 2 * fluid.mass[i] / 1000 * norm(backend.wall_share_[i].gradient);
  return area;
}

TEST(WallArea, AddsUpToThatOfALevelBed) {
  for (const int dimension : {2, 3}) {
    FlowModel model = viscous(1);
    model.dimension = dimension;
    model.periodic.period[0] = {0.8, 0, 0};
    if (dimension == 3) model.periodic.period[1] = {0, 0.8, 0};
    OpenedReference backend(model);
    test::add_block(backend.fluid(), model, {0, 8, 0, 8, 0, 6});
    test::add_block(backend.boundary(), model, {0, 8, 0, 8, -3, 0});
    prepare(backend);
    const double area = dimension == 3 ? 0.64 : 0.8;
    EXPECT_NEAR(bed_area(backend, backend.fluid(), [](const Vec3d&) { return true; }) / area, 1,
                0.01);
  }
}

// A DEM that falls by tan 30 deg along x; fluid in layers parallel to it. Only particles over the
// middle count, 10 of 20 columns along the slope and 6 of 14 across.
TEST(WallArea, AddsUpToThatOfASlopeOfTheDem) {
  const double angle = M_PI / 6, dp = 0.5;
  Grid grid{41, 31, -20.5, 15.5, 1, 1};
  Raster elevation(grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      elevation.at(column, row) = -std::tan(angle) * grid.x_of(column);
  const Surface surface{std::move(elevation)};
  FlowModel model = viscous(1);
  model.spacing = dp;
  model.h = 1.5 * dp;
  Ground ground(surface, {}, {dp, 3, 1000});
  OpenedReference backend(model);
  const Vec3d along{std::cos(angle), 0, -std::sin(angle)},
      normal{std::sin(angle), 0, std::cos(angle)};
  for (int k = 0; k < 5; ++k)
    for (int j = -7; j < 7; ++j)
      for (int i = -10; i < 10; ++i)
        add_particle(
            backend.fluid(), model,
            (i + 0.5) * dp * along + Vec3d{0, (j + 0.5) * dp, 0} + (k + 0.5) * dp * normal);
  test::follow(ground, backend.fluid().position, 2.2 * model.h, backend.boundary());
  prepare(backend);
  const auto is_inside = [&](const Vec3d& x) {
    return std::abs(dot(x, along)) < 5 * dp && std::abs(x.y) < 3 * dp;
  };
  EXPECT_NEAR(bed_area(backend, backend.fluid(), is_inside) / (60 * dp * dp), 1, 0.01);
}

// Forces between particles come in pairs, so the sum of momentum does not change.
TEST(ImplicitStep, KeepsMomentumWithoutWalls) {
  for (const test::On kind : test::backends()) {
    auto backend = test::make_backend(kind, viscous(5));
    test::fill(*backend, {});
    backend->boundary().resize(0);
    set_viscosity(backend->fluid(), 5);
    prepare(*backend);
    const double scale = std::sqrt(2 * kinetic_energy_of(backend->fluid()) *
                                   static_cast<double>(backend->fluid().size()));
    const Vec3d before = momentum_of(backend->fluid());
    // Whatever the solve leaves undone: speeds are about 1 m/s.
    const ViscousSolve solve = advance_velocity(*backend, 0.01, 1e-3, 500);
    ASSERT_TRUE(solve.converged && solve.iterations > 0);
    const double tolerance = kind == test::On::reference ? 1e-14 : 1e-8;
    EXPECT_LT(norm(momentum_of(backend->fluid()) - before), tolerance * scale);
  }
}

// A block slides along a bed without pressure or viscosity: nothing may hold it back.
TEST(ArtificialViscosity, IsNoFrictionAtWalls) {
  for (const test::On kind : test::backends()) {
    FlowModel model = viscous(0);
    model.artificial_viscosity = 0.05;
    auto backend = test::make_backend(kind, model);
    test::add_block(backend->fluid(), model, {0, 4, 0, 4, 0, 3});
    test::add_block(backend->boundary(), model, {-4, 8, -4, 8, -3, 0});
    for (Vec3d& v : backend->fluid().velocity) v = {2, 0, 0};
    prepare(*backend);
    for (const Vec3d& a : backend->accelerations()) EXPECT_LT(norm(a), 1e-9);
  }
}

// Whatever the step, the viscosities and the velocities, friction takes energy, and heat is what it
// took.
TEST(ImplicitStep, NeverAddsKineticEnergy) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(0, 1);
  for (int trial = 0; trial < 20; ++trial) {
    OpenedReference backend(viscous(1));
    test::fill(backend, {}, 4);
    for (std::size_t i = 0; i < backend.fluid().size(); ++i) {
      backend.fluid().viscosity[i] = std::pow(10, 6 * u(random) - 2);
      backend.fluid().density[i] = 1000;  // no pressure, which is not the step's
      backend.fluid().drag[i] = 100.0 * Vec3d{u(random) - 0.5, u(random) - 0.5, u(random) - 0.5};
    }
    prepare(backend);
    const double before = kinetic_energy_of(backend.fluid());
    const ViscousSolve solve = advance_velocity(backend, std::pow(10, -4 * u(random)), 1e-10, 5000);
    ASSERT_TRUE(solve.converged);
    const double heat = backend.heat().viscosity;
    EXPECT_GT(heat, 0);
    EXPECT_LT(kinetic_energy_of(backend.fluid()), before);
    EXPECT_NEAR(kinetic_energy_of(backend.fluid()) + heat, before, 1e-6 * before);
  }
}

// Pressure drives a particle straight out of the wall: what holds it there is the viscosity at that
// speed, not the one at rest.
TEST(WallResistance, IsThatOfTheWholeVelocity) {
  FlowModel model = viscous(1);
  model.rheology = Cross{1, 1e5, 1};
  model.yield = {100, 0, 0};
  std::vector<double> drag[2];
  for (const bool is_across : {false, true}) {
    model.periodic.period = {Vec3d{0.8, 0, 0}, Vec3d{0, 0.8, 0}, Vec3d{}};
    OpenedReference backend(model);
    test::add_block(backend.fluid(), model, {0, 8, 0, 8, 0, 6});
    test::add_block(backend.boundary(), model, {0, 8, 0, 8, -3, 0});
    backend.fluid().velocity.assign(backend.fluid().size(),
                                    is_across ? Vec3d{0, 0, 0.5} : Vec3d{0.5, 0, 0});
    prepare(backend);
    drag[is_across] = backend.wall_drag_;
  }
  EXPECT_GT(drag[0].front(), 0);
  for (std::size_t i = 0; i < drag[0].size(); ++i) EXPECT_NEAR(drag[1][i], drag[0][i], 1e-9);
}

TEST(ImplicitStep, WithoutViscosityIsTheExplicitOne) {
  for (const test::On kind : test::backends()) {
    FlowModel model = viscous(0);
    model.gravity = {0, 0, -9.81};
    auto backend = test::make_backend(kind, model);
    test::fill(*backend, {});
    set_viscosity(backend->fluid(), 0);
    prepare(*backend);
    const std::vector<Vec3d> before = backend->fluid().velocity;
    const ViscousSolve solve = advance_velocity(*backend, 0.01, 1e-9, 10);
    EXPECT_TRUE(solve.converged);
    EXPECT_EQ(solve.iterations, 0);
    EXPECT_NEAR(backend->heat().viscosity, 0, 1e-9);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec3d pushed = before[i] + 0.01 * backend->accelerations()[i];
      if (kind == test::On::cuda) {  // which multiplies and adds in one
        EXPECT_LT(norm(backend->fluid().velocity[i] - pushed), 1e-15);
      } else {
        EXPECT_EQ(backend->fluid().velocity[i], pushed);
      }
    }
  }
}

TEST(ImplicitStep, LeavesTheStateAsItWasWhenItFails) {
  for (const test::On kind : test::backends()) {
    auto backend = test::make_backend(kind, viscous(1e4));
    test::fill(*backend, {});
    set_viscosity(backend->fluid(), 1e4);
    prepare(*backend);
    const std::vector<Vec3d> velocity = backend->fluid().velocity, drag = backend->fluid().drag;
    const ViscousSolve solve = advance_velocity(*backend, 1, 1e-9, 2);
    EXPECT_FALSE(solve.converged);
    EXPECT_EQ(solve.iterations, 2);
    EXPECT_EQ(backend->fluid().velocity, velocity);
    EXPECT_EQ(backend->fluid().drag, drag);
  }
}

}  // namespace
}  // namespace sabo
