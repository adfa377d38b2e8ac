#include <cmath>
#include <vector>

#include "rasters.hpp"
#include <gtest/gtest.h>

#include "terrain/dam_mesh.hpp"
#include "terrain/ground.hpp"

// Dams 20 m along y and 2 m thick about x = 0, 6 m high on level ground, particles of 0.5 m.

namespace sabo {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

CheckDam dam_with(std::vector<Opening> openings) {
  CheckDam dam{"test", {{{0, -10, 0}, {0, 10, 0}}, false}, 6, 2};
  dam.openings = std::move(openings);
  return dam;
}

/// A slit to the ground, one above a sill of 2 m, and a culvert of 1.5 m.
CheckDam slit_dam() {
  return dam_with({{4, 6, -infinity, infinity}, {9, 12, 2, infinity}, {15, 16.5, -infinity, 1.5}});
}

/// Volume of the boundary particles above the ground, m3.
double volume_of(const CheckDam& dam) {
  const Surface surface = flat();
  const GroundSettings settings{0.5, 3, 2000};
  std::vector<GroundPoint> points;
  for (const DamColumn& column : dam_columns(dam, surface, settings.spacing))
    fill_column(column, settings, points);
  double mass = 0;
  for (const GroundPoint& point : points) {
    mass += point.mass;
    EXPECT_TRUE(dam.contains(point.position))
        << point.position.x << ' ' << point.position.y << ' ' << point.position.z;
  }
  return mass / settings.density;
}

TEST(DamOpenings, AreNotInTheDam) {
  const CheckDam dam = slit_dam();  // stations count from y = -10
  EXPECT_FALSE(dam.contains({0, -5, 0.1}));
  EXPECT_FALSE(dam.contains({0.9, -4.1, 5.9}));
  EXPECT_TRUE(dam.contains({0, -3.9, 5.9}));
  EXPECT_TRUE(dam.contains({0, 1, 1.9}));  // the sill
  EXPECT_FALSE(dam.contains({0, 1, 2.1}));
  EXPECT_FALSE(dam.contains({0, 6, 1.4}));
  EXPECT_TRUE(dam.contains({0, 6, 1.6}));  // over the culvert
}

TEST(DamOpenings, LeaveTheParticlesTheRestOfTheVolume) {
  EXPECT_NEAR(volume_of(dam_with({})), 2 * 20 * 6, 1e-9);
  EXPECT_NEAR(volume_of(slit_dam()), 2 * (20 * 6 - 2 * 6 - 3 * 4 - 1.5 * 1.5), 1e-9);
}

TEST(DamOpenings, PostsMayBeThinnerThanTheDam) {
  // Gaps of 2 m at 3 and 6 m with a post of 1 m between them, 0.4 m thick.
  const CheckDam dam = dam_with(
      {{3, 5, -infinity, infinity}, {6, 8, -infinity, infinity}, {3, 8, -infinity, infinity, 0.4}});
  EXPECT_TRUE(dam.contains({0.15, -4.5, 3}));
  EXPECT_FALSE(dam.contains({0.25, -4.5, 3}));
  EXPECT_FALSE(dam.contains({0, -5.5, 3}));
  EXPECT_NEAR(volume_of(dam), 2 * 15 * 6 + 0.4 * 1 * 6, 1e-9);
}

TEST(DamOpenings, LetTheWayOutOfTheWallLeadIntoThem) {
  const Surface surface = flat();
  const Ground ground(surface, {slit_dam()}, {0.5, 3, 2000});
  const double hair = 0.0005;
  const auto expect_moved = [&](const Vec3d& from, const Vec3d& to) {
    EXPECT_TRUE(ground.is_solid(from));
    const Vec3d moved = ground.pushed_out(from);
    EXPECT_NEAR(norm(moved - to), 0, 1e-9) << moved.x << ' ' << moved.y << ' ' << moved.z;
  };
  expect_moved({0.2, -3.7, 3}, {0.2, -4 - hair, 3});  // into the slit
  expect_moved({0, 0.5, 1.8}, {0, 0.5, 2 + hair});    // up on the sill
  expect_moved({0, 5.7, 1.7}, {0, 5.7, 1.5 - hair});  // down into the culvert
  expect_moved({-0.9, -7, 3}, {-1 - hair, -7, 3});    // through the face
  EXPECT_FALSE(ground.is_solid({0, -5, 1}));
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3d point{3 * random() - 1.5, 22 * random() - 11, 8 * random() - 1};
    EXPECT_FALSE(ground.is_solid(ground.pushed_out(point)));
  }
}

TEST(DamBends, AreFullOnTheirOuterAndSingleOnTheirInnerSide) {
  // A right angle of a wall 4 m thick: two arms of 10 m, of which a square of 2 m x 2 m is common,
  // and a quarter of a circle of 2 m.
  CheckDam dam{"bent", {{{-10, 0, 0}, {0, 0, 0}, {0, 10, 0}}, false}, 1, 4};
  EXPECT_NEAR(volume_of(dam), 2 * 10 * 4 - 2 * 2 + M_PI, 0.01);
  dam.axis.vertices[2] = {0, -10, 0};  // the other way round
  EXPECT_NEAR(volume_of(dam), 2 * 10 * 4 - 2 * 2 + M_PI, 0.01);
}

TEST(DamProfile, IsTheCrest) {
  CheckDam dam = dam_with({});
  dam.profile = {3, 5, 4};
  EXPECT_DOUBLE_EQ(dam.top(0), 3);
  EXPECT_DOUBLE_EQ(dam.top(5), 4);
  EXPECT_DOUBLE_EQ(dam.top(15), 4.5);
  EXPECT_DOUBLE_EQ(dam.top(25), 4);
}

TEST(DamMesh, HoldsTheWallAndNotItsOpenings) {
  const Surface surface = flat();
  // Blocks that stand on the ground go on for 0.5 m below it; not the one over the culvert.
  const double below = 0.5 * 2 * (20 - 2 - 1.5);
  EXPECT_NEAR(volume(dam_mesh(slit_dam(), surface, 0.5)),
              2 * (20 * 6 - 2 * 6 - 3 * 4 - 1.5 * 1.5) + below, 1e-3);
}

TEST(DamMesh, KeepsANotch) {
  CheckDam dam = dam_with({});
  dam.notch = Notch{9, 4, 2, 0.5};
  const double notch_area = 4 * 2 + 2 * 0.5 * (2 * 0.5 * 2);  // sill and two triangles
  EXPECT_NEAR(volume(dam_mesh(dam, flat(), 0)), 2 * (20 * 6 - notch_area), 1e-3);
}

TEST(DamMesh, IsMitredInABend) {
  const CheckDam dam{"bent", {{{-10, 0, 0}, {0, 0, 0}, {0, 10, 0}}, false}, 1, 4};
  EXPECT_NEAR(volume(dam_mesh(dam, flat(), 0)), 2 * 10 * 4, 1e-3);
}

}  // namespace
}  // namespace sabo
