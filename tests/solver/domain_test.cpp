#include "solver/domain.hpp"

#include <algorithm>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "terrain/ground.hpp"

namespace sabo {
namespace {

/// A level floor at z = 0 of 20 x 20 m around the origin, vertices every metre.
Surface wide_floor() {
  Grid grid{21, 21, -10.5, 10.5, 1, 1};
  return Surface(Raster(grid, 0.0));
}

/// The last `driven` of them are driven.
std::unique_ptr<Backend> flow_at(test::On kind, const std::vector<Vec3d>& positions,
                                 std::size_t driven = 0) {
  auto backend = test::make_backend(kind, test::plain_model(0.5, 60, 50));
  Particles& p = backend->fluid();
  p.resize(positions.size());
  p.position = positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    p.mass[i] = 1;
    p.velocity[i] = {1, 1, -1};
    p.id[i] = static_cast<std::uint32_t>(i);
    p.driven[i] = i + driven >= positions.size() ? 1 : 0;
  }
  backend->find_neighbours();
  return backend;
}

/// Row of a particle.
std::size_t row_of(std::uint32_t id, const Particles& of) {
  return static_cast<std::size_t>(std::ranges::find(of.id, id) - of.id.begin());
}

TEST(Domain, TakesOutWhatLeftThePlan) {
  const Surface floor = wide_floor();
  for (const test::On kind : test::backends()) {
    Ground ground(floor, {}, {0.5, 3, 1000});
    Domain domain(ground);
    const auto flow = flow_at(kind, {{0, 0, 1}, {25, 0, 1}, {0, -25, 1}});
    domain.update(*flow);
    const Particles& fluid = flow->fluid();
    ASSERT_EQ(fluid.size(), 1u);
    EXPECT_EQ(fluid.id[0], 0u);
    const Particles departed = domain.take_departed();
    ASSERT_EQ(departed.size(), 2u);
    EXPECT_EQ(departed.position[row_of(2, departed)], (Vec3d{0, -25, 1}));
    EXPECT_EQ(departed.position[row_of(1, departed)], (Vec3d{25, 0, 1}));
    EXPECT_EQ(domain.take_departed().size(), 0u);
  }
}

TEST(Domain, PutsBackWhatIsBelowTheGroundAndCountsIt) {
  const Surface floor = wide_floor();
  for (const test::On kind : test::backends()) {
    Ground ground(floor, {}, {0.5, 3, 1000});
    Domain domain(ground);
    const std::vector<Vec3d> before{
        {0, 0, 0.2}, {1, 0, -0.2}, {2, 0, 0.3}, {3, 0, -0.4}, {4, 0, -0.2}};
    const auto flow = flow_at(kind, before, 1);
    domain.update(*flow);
    const Particles& fluid = flow->fluid();
    EXPECT_EQ(domain.put_back_count(), 2u);
    for (const std::uint32_t id : {1u, 3u}) {
      const Vec3d& x = fluid.position[row_of(id, fluid)];
      EXPECT_EQ(x.x, before[id].x);
      EXPECT_GE(x.z, 0);
      EXPECT_NEAR(x.z, 0, 0.01);
      // It slides on.
      EXPECT_NEAR(norm(fluid.velocity[row_of(id, fluid)] - Vec3d{1, 1, 0}), 0, 1e-12);
    }
    for (const std::uint32_t id : {0u, 2u, 4u}) {  // the last one is for its inflow to move
      EXPECT_EQ(fluid.position[row_of(id, fluid)], before[id]);
      EXPECT_EQ(fluid.velocity[row_of(id, fluid)], (Vec3d{1, 1, -1}));
    }
  }
}

TEST(Domain, MakesGroundOnlyNearTheFlow) {
  const Surface floor = wide_floor();
  Ground ground(floor, {}, {0.5, 3, 1000});
  Domain domain(ground);
  const auto flow = flow_at(test::On::reference, {{-8, -8, 1}});
  const Particles& boundary = flow->boundary();
  domain.update(*flow);
  EXPECT_GT(boundary.size(), 50u);
  for (const Vec3d& x : boundary.position) EXPECT_LT(x.x, 0);
  flow->fluid().position[0] = {8, 8, 1};
  domain.update(*flow);
  EXPECT_GT(boundary.size(), 50u);
  for (const Vec3d& x : boundary.position) EXPECT_GT(x.x, 0);
}

/// A plane that falls by 0.5 m per m along x, 60 m long.
Surface slope() {
  Grid grid{61, 13, -0.5, 12.5, 1, 1};
  Raster elevation(grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      elevation.at(column, row) = -0.5 * grid.x_of(column);
  return Surface(std::move(elevation));
}

// Both backends carry the ground along with a slide that soon leaves the first tiles.
TEST(Domain, HoldsASlideOnASlope) {
  const Surface ground_surface = slope();
  std::vector<double> mean_x;
  for (const test::On kind : test::backends()) {
    const FlowModel model = test::plain_model(0.5, 60, 50);
    Ground ground(ground_surface, {}, {model.spacing, 3, 1000});
    Domain domain(ground);
    auto backend = test::make_backend(kind, model);
    test::add_block(backend->fluid(), model, {6, 10, 10, 14, 0, 3});
    for (Vec3d& x : backend->fluid().position) x.z += ground_surface.height(x.x, x.y);
    PaperStepper stepper(*backend, test::rule_of(model), &domain);
    while (stepper.time() < 2.5) stepper.step();
    double x = 0;
    for (const Vec3d& p : backend->fluid().position) {
      x += p.x / static_cast<double>(backend->fluid().size());
      EXPECT_FALSE(ground.is_solid(p));
    }
    EXPECT_EQ(backend->fluid().size(), 48u);
    EXPECT_EQ(domain.put_back_count(), 0u);
    EXPECT_GT(x, 4 + 5);  // it moved by more than a tile of 4 m
    mean_x.push_back(x);
  }
  EXPECT_NEAR(mean_x[1], mean_x[0], 0.02 * mean_x[0]);
}

}  // namespace
}  // namespace sabo
