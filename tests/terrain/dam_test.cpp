#include <algorithm>
#include <cmath>
#include <numeric>

#include "rasters.hpp"
#include "support/ground.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "terrain/ground.hpp"

namespace sabo {
namespace {

/// 20 m along y, 2.5 m thick, 6 m high; the notch's sides rise 2 m over 1 m.
CheckDam notched_dam() {
  CheckDam dam;
  dam.name = "test";
  dam.axis = {{{0.1, -10, 0}, {0.1, 10, 0}}, false};
  dam.crest = 6;
  dam.thickness = 2.5;
  dam.notch = Notch{9, 4, 2, 0.5};
  return dam;
}

TEST(CheckDam, TopFollowsTheNotch) {
  const CheckDam dam = notched_dam();
  EXPECT_DOUBLE_EQ(dam.top(0), 6);
  EXPECT_DOUBLE_EQ(dam.top(9), 4);
  EXPECT_DOUBLE_EQ(dam.top(11), 4);
  EXPECT_DOUBLE_EQ(dam.top(11.5), 5);
  EXPECT_DOUBLE_EQ(dam.top(12), 6);
}

TEST(CheckDam, CrestMayComeFromTheLine) {
  CheckDam dam = notched_dam();
  dam.notch.reset();
  dam.axis = {{{0, -10, 5}, {0, 10, 9}}, true};
  EXPECT_DOUBLE_EQ(dam.top(5), 6);
  EXPECT_DOUBLE_EQ(dam.top(-3), 5);
}

TEST(CheckDam, ContainsItsWall) {
  const CheckDam dam = notched_dam();
  EXPECT_TRUE(dam.contains({1.3, -8, 5.9}));
  EXPECT_FALSE(dam.contains({1.4, -8, 5.9}));
  EXPECT_FALSE(dam.contains({0, -8, 6.1}));
  EXPECT_FALSE(dam.contains({0, -1, 4.5}));  // in the notch
  EXPECT_TRUE(dam.contains({0, -1, 3.5}));
  EXPECT_FALSE(dam.contains({0, 10.1, 1}));
}

TEST(DamColumns, FillTheVolumeExactly) {
  const Surface surface = flat();
  const GroundSettings settings{0.7, 3, 2000};
  std::vector<GroundPoint> points;
  for (const DamColumn& column : dam_columns(notched_dam(), surface, settings.spacing)) {
    fill_column(column, settings, points);
  }
  double mass = 0;
  for (const GroundPoint& point : points) {
    mass += point.mass;
    EXPECT_TRUE(notched_dam().contains(point.position));
  }
  const double notch_area = 4 * 2 + 2 * 0.5 * (2 * 0.5 * 2);  // sill and two triangles
  EXPECT_NEAR(mass / 2000, 2.5 * (20 * 6 - notch_area), 1e-9);
}

TEST(DamColumns, AreDenseAndAtLeastTwoAcross) {
  CheckDam thin = notched_dam();
  thin.thickness = 0.3;
  const Surface surface = flat();
  const std::vector<DamColumn> columns = dam_columns(thin, surface, 0.7);
  std::vector<double> x;
  std::vector<double> y;
  for (const DamColumn& column : columns) {
    x.push_back(column.x);
    y.push_back(column.y);
  }
  EXPECT_NEAR(*std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end()), 0.15,
              1e-12);
  std::sort(y.begin(), y.end());
  for (std::size_t k = 1; k < y.size(); ++k) EXPECT_LE(y[k] - y[k - 1], 0.7 + 1e-9);
  EXPECT_LE(y.front(), -10 + 0.35 + 1e-9);
  EXPECT_GE(y.back(), 10 - 0.35 - 1e-9);
}

TEST(DamColumns, RefuseADamBelowTheGroundOrTooLarge) {
  const Surface surface = flat();
  CheckDam dam = notched_dam();
  dam.crest = -1;
  EXPECT_THROW(dam_columns(dam, surface, 0.7), CaseError);
  dam = notched_dam();
  dam.thickness = 1e12;
  EXPECT_THROW(dam_columns(dam, surface, 0.7), CaseError);
  dam = notched_dam();
  dam.crest = 1e12;
  EXPECT_THROW(dam_columns(dam, surface, 0.7), CaseError);
}

TEST(GroundWithDam, MakesTheDamOnce) {
  const Surface surface = flat();
  Ground ground(surface, {notched_dam()}, {0.5, 3, 2000});
  std::vector<Vec3d> fluid;
  for (double y = -10; y <= 10; y += 0.5) fluid.push_back({-2, y, 0.5});
  Particles boundary;
  test::follow(ground, fluid, 4, boundary);
  double above = 0;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (boundary.position[k].z > 0) above += boundary.mass[k];
  }
  EXPECT_NEAR(above / 2000, 2.5 * (20 * 6 - 10), 1e-9);
}

TEST(GroundWithDam, PushesOutThroughTheNearestFace) {
  const Surface surface = flat();
  const Ground ground(surface, {notched_dam()}, {0.5, 3, 2000});
  const double hair = 0.0005;
  const auto expect_moved = [&](const Vec3d& from, const Vec3d& to) {
    EXPECT_TRUE(ground.is_solid(from));
    const Vec3d moved = ground.pushed_out(from);
    EXPECT_FALSE(ground.is_solid(moved));
    EXPECT_NEAR(norm(moved - to), 0, 1e-9) << moved.x << ' ' << moved.y << ' ' << moved.z;
  };
  expect_moved({-1.0, 2, 3}, {0.1 - 1.25 - hair, 2, 3});
  expect_moved({1.0, 6, 3}, {0.1 + 1.25 + hair, 6, 3});
  expect_moved({0, -8, 5.8}, {0, -8, 6 + hair});
  expect_moved({0, -9.9, 1}, {0, -10 - hair, 1});
}

TEST(GroundWithDam, PushesOutOfTheFootOfTheWall) {
  const Surface surface = flat();
  const Ground ground(surface, {notched_dam()}, {0.5, 3, 2000});
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3d point{3 * random() - 1.5, 22 * random() - 11, 8 * random() - 1};
    EXPECT_FALSE(ground.is_solid(ground.pushed_out(point)));
  }
}

}  // namespace
}  // namespace sabo
