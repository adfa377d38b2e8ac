#include "terrain/ground.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "rasters.hpp"
#include "support/ground.hpp"
#include <gtest/gtest.h>

#include "math/angle.hpp"

namespace sabo {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Surface slope(double degrees, double reach = 40) {
  const double rise = std::tan(degrees * degree);
  return Surface(
      raster_of(square_grid(-reach, reach, 1), [rise](double x, double) { return rise * x; }));
}

Surface rough_hill() {
  Random random;
  return Surface(raster_of(square_grid(-30, 30, 1), [&](double x, double y) {
    return 8 * std::sin(x / 7) * std::cos(y / 9) + 0.5 * random();
  }));
}

class GroundOnAPlane : public testing::TestWithParam<int> {};

TEST_P(GroundOnAPlane, FillsTheLayersExactly) {
  const double angle = GetParam() * degree;
  const Surface surface = slope(GetParam());
  Ground ground(surface, {}, {0.5, 3, 2000});
  Particles particles;
  ground.make_all(-8, -8, 8, 8, particles);
  const double vertical_depth = 3 * 0.5 / std::cos(angle);
  EXPECT_NEAR(sum(particles.mass), 2000 * 16 * 16 * vertical_depth, 1e-6);

  const Vec3d normal{-std::sin(angle), 0, std::cos(angle)};
  std::map<int, int> layers;
  for (const Vec3d& p : particles.position) {
    const double depth = -dot(p, normal) / 0.5;
    const int layer = static_cast<int>(std::floor(depth));
    EXPECT_NEAR(depth, layer + 0.5, 1e-9);
    ++layers[layer];
  }
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0], layers[1]);
  EXPECT_EQ(layers[0], layers[2]);
}

TEST_P(GroundOnAPlane, ColumnsAreCloseAlongTheGround) {
  const double angle = GetParam() * degree;
  const Surface surface = slope(GetParam());
  Ground ground(surface, {}, {0.5, 1, 1000});
  Particles particles;
  ground.make_all(-4, -4, 4, 4, particles);
  std::set<long> places;
  for (const Vec3d& p : particles.position) places.insert(std::lround(p.x * 1e6));
  double largest = 0;
  for (auto next = std::next(places.begin()); next != places.end(); ++next) {
    largest = std::max(largest, static_cast<double>(*next - *std::prev(next)) / 1e6);
  }
  EXPECT_LE(largest / std::cos(angle), 1.25 * 0.5 + 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Slopes, GroundOnAPlane, testing::Values(0, 30, 45, 60));

TEST(Ground, LeavesNoGapUnderRoughGround) {
  const Surface surface = rough_hill();
  const double spacing = 0.5;
  Ground ground(surface, {}, {spacing, 3, 1000});
  Particles particles;
  ground.make_all(-6, -6, 6, 6, particles);
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    const double x = 10 * random() - 5;
    const double y = 10 * random() - 5;
    const Vec3d point{x, y, surface.height(x, y)};
    double nearest = 1e9;
    for (const Vec3d& p : particles.position) nearest = std::min(nearest, norm(p - point));
    EXPECT_LT(nearest, 1.0 * spacing) << x << ' ' << y;
  }
}

TEST(Ground, StaysBelowTheSurface) {
  const Surface surface = rough_hill();
  Ground ground(surface, {}, {0.7, 3, 1000});
  Particles particles;
  ground.make_all(-20, -20, 20, 20, particles);
  for (const Vec3d& p : particles.position) EXPECT_TRUE(ground.is_solid(p));
}

TEST(Ground, GoesOnStraightBeyondAnEdge) {
  const Surface surface = slope(30, 10);
  Ground ground(surface, {}, {0.5, 3, 1000});
  Particles boundary;
  test::follow(ground, {{9.9, 0, 6}}, 3, boundary);
  const Vec3d normal{-0.5, 0, std::sqrt(0.75)};
  double farthest = 0;
  for (const Vec3d& p : boundary.position) {
    const double depth = -dot(p, normal) / 0.5;
    EXPECT_NEAR(depth, std::floor(depth) + 0.5, 1e-9);
    EXPECT_LT(depth, 3);
    farthest = std::max(farthest, p.x);
  }
  EXPECT_GT(farthest, 10 + 1.5);
  EXPECT_LE(farthest, 10 + 4 * 0.5);
}

TEST(Ground, HasNoneFarOutside) {
  const Surface surface = slope(0, 10);
  Ground ground(surface, {}, {0.5, 3, 1000});
  Particles boundary;
  EXPECT_FALSE(
      test::follow(ground, {{1e300, 0, 0}, {std::nan(""), 0, 0}, {-500, 3, 0}}, 3, boundary));
  EXPECT_EQ(boundary.size(), 0U);
  EXPECT_EQ(ground.tile_count(), 0U);
}

TEST(Ground, FollowsTheFlowAndKeepsFields) {
  const Surface surface = rough_hill();
  Ground ground(surface, {}, {0.5, 3, 1000});
  Particles boundary;
  EXPECT_TRUE(test::follow(ground, {{-5, 0, 5}, {-4, 1, 5}}, 2, boundary));
  EXPECT_FALSE(test::follow(ground, {{-5, 0, 5}, {-4, 1, 5}}, 2, boundary));

  std::map<std::uint32_t, double> marks;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    boundary.density[k] = 900 + boundary.id[k];
    marks[boundary.id[k]] = boundary.density[k];
  }
  std::vector<std::uint32_t> order(boundary.size());
  std::iota(order.begin(), order.end(), 0U);
  Random random;
  for (std::size_t k = order.size(); k > 1; --k) {
    std::swap(order[k - 1], order[static_cast<std::size_t>(random() * k)]);
  }
  boundary.permute(order);

  EXPECT_TRUE(test::follow(ground, {{-1, 0, 5}}, 2, boundary));
  std::size_t kept = 0;
  std::set<std::uint32_t> ids;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    EXPECT_TRUE(ids.insert(boundary.id[k]).second);
    EXPECT_GT(boundary.position[k].x, -4.01);  // the tile from x = -8 to -4 is gone
    if (const auto mark = marks.find(boundary.id[k]); mark != marks.end()) {
      ++kept;
      EXPECT_EQ(boundary.density[k], mark->second);
    } else {
      EXPECT_EQ(boundary.density[k], 1000);
      EXPECT_EQ(boundary.velocity[k], Vec3d{});
    }
  }
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, marks.size());
  EXPECT_LT(kept, boundary.size());
}

TEST(Ground, IsTheSameForAnyNumberOfThreads) {
  const Surface surface = rough_hill();
  const GroundSettings settings{0.5, 2, 1000};
  Ground one(surface, {}, settings), three(surface, {}, settings);
  Random random;
  for (const double shift : {0.0, 6.0}) {
    std::vector<Vec3d> fluid;
    for (int k = 0; k < 5000; ++k)
      fluid.push_back({10 * random() - 10 + shift, 10 * random() - 10, 0});
    const BoundaryChange a = one.follow(fluid, 1.5, 1), b = three.follow(fluid, 1.5, 3);
    EXPECT_GT(a.made.size(), 500U);
    EXPECT_EQ(a.made.position, b.made.position);
    EXPECT_EQ(a.made.mass, b.made.mass);
    EXPECT_EQ(a.made.id, b.made.id);
    EXPECT_EQ(a.dropped.empty(), shift == 0);
    ASSERT_EQ(a.dropped.size(), b.dropped.size());
    for (std::size_t k = 0; k < a.dropped.size(); ++k) {
      EXPECT_EQ(a.dropped[k].first, b.dropped[k].first);
      EXPECT_EQ(a.dropped[k].count, b.dropped[k].count);
    }
  }
}

TEST(Ground, MakesAllTilesWithinReach) {
  const Surface surface = rough_hill();
  const GroundSettings settings{0.5, 2, 1000};
  Ground ground(surface, {}, settings);
  Particles boundary;
  Random random;
  std::vector<Vec3d> fluid;
  for (int k = 0; k < 300; ++k) fluid.push_back({20 * random() - 10, 20 * random() - 10, 0});
  test::follow(ground, fluid, 1.5, boundary);
  Ground whole(surface, {}, settings);
  Particles all;
  whole.make_all(-12, -12, 12, 12, all);
  const auto order = [](const Vec3d& a, const Vec3d& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(boundary.position.begin(), boundary.position.end(), order);
  for (const Vec3d& p : all.position) {
    const bool is_near = std::any_of(fluid.begin(), fluid.end(), [&](const Vec3d& f) {
      return std::hypot(f.x - p.x, f.y - p.y) < 1.5;
    });
    if (!is_near) continue;
    EXPECT_TRUE(std::binary_search(boundary.position.begin(), boundary.position.end(), p, order));
  }
}

TEST(Ground, DropsEverythingWithoutFluid) {
  const Surface surface = slope(20);
  Ground ground(surface, {}, {0.5, 3, 1000});
  Particles boundary;
  test::follow(ground, {{0, 0, 1}}, 2, boundary);
  EXPECT_GT(boundary.size(), 0U);
  EXPECT_TRUE(test::follow(ground, {}, 2, boundary));
  EXPECT_EQ(boundary.size(), 0U);
  EXPECT_EQ(ground.tile_count(), 0U);
}

TEST(Ground, PushesOutAlongTheNormal) {
  const Surface surface = slope(30);
  const Ground ground(surface, {}, {0.5, 3, 1000});
  const Vec3d normal{-0.5, 0, std::sqrt(0.75)};
  const Vec3d foot{1, 2, std::tan(std::numbers::pi / 6)};
  const Vec3d moved = ground.pushed_out(foot - 0.3 * normal);
  EXPECT_NEAR(norm(moved - (foot + 0.0005 * normal)), 0, 1e-9);
}

TEST(Ground, PushesOutOfAnyPlaceInRoughGround) {
  const Surface surface = rough_hill();
  const Ground ground(surface, {}, {0.5, 3, 1000});
  Random random;
  for (int trial = 0; trial < 1000; ++trial) {
    const double x = 50 * random() - 25;
    const double y = 50 * random() - 25;
    const Vec3d inside{x, y, surface.height(x, y) - 3 * random()};
    const Vec3d moved = ground.pushed_out(inside);
    EXPECT_FALSE(ground.is_solid(moved));
    EXPECT_LE(norm(moved - inside), surface.nearest(inside, 10)->distance + 0.1);
  }
}

}  // namespace
}  // namespace sabo
