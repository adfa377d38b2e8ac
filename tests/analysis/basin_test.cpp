#include "analysis/basin.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/cloud.hpp"
#include "analysis/columns.hpp"

namespace sabo {
namespace {

/// A channel along x that rises by `slope` eastwards from 0 at x = 0, 10 m wide between banks of
/// `bank` m; cells of 1 m. Along x it is 60 m long, from -30 to 30.
Raster channel(double slope, double bank) {
  Raster ground({60, 14, -30, 7, 1, 1});
  for (int row = 0; row < 14; ++row)
    for (int column = 0; column < 60; ++column) {
      const double bed = slope * ground.grid.x_of(column);
      ground.at(column, row) = std::abs(ground.grid.y_of(row)) < 5 ? bed : bed + bank;
    }
  return ground;
}

/// Across the channel at x = 0, 2 m thick, up to an elevation; upstream (east) is on its right.
CheckDam dam_of(double crest, double half_length = 7) {
  return {"dam", Polyline{{{0, -half_length, 0}, {0, half_length, 0}}}, crest, 2};
}
constexpr int east = -1;

TEST(Basin, HoldsTheWedgeBelowItsCrest) {
  // Cells at x = 1.5, 2.5, ... 9.5 lie below 1 m on a bed of 0.1: sum of 1 - 0.1 x, 10 m wide.
  const Basin basin(channel(0.1, 20), dam_of(1), east);
  EXPECT_NEAR(basin.capacity(), 10 * (9 - 0.1 * (1.5 + 9.5) / 2 * 9), 1e-9);
  EXPECT_EQ(basin.level(), 1);
  EXPECT_FALSE(basin.is_flanked());
  EXPECT_NEAR(basin.foot(), 0.15, 1e-12);
}

TEST(Basin, IsAsHighAsTheSillOfTheNotch) {
  CheckDam dam = dam_of(2);
  dam.notch = Notch{7, 2, 1};
  const Basin basin(channel(0.1, 20), dam, east);
  EXPECT_EQ(basin.level(), 1);
}

TEST(Basin, IsDrainedByTheSaddleBesideADamTooShort) {
  // 4 m long: at its ends the flow goes round on the bed, whose highest cell to pass is at x = 0.5.
  const Basin basin(channel(0.1, 20), dam_of(1, 2), east);
  EXPECT_TRUE(basin.is_flanked());
  EXPECT_LT(basin.level(), 0.3);
  // Banks of 0.5 m let the pool out over the valley's side: it leaves the map there.
  const Basin low(channel(0.1, 0.5), dam_of(1), east);
  EXPECT_TRUE(low.is_flanked());
  EXPECT_NEAR(low.level(), 0.15 + 0.5, 1e-12);
  EXPECT_LT(low.capacity(), Basin(channel(0.1, 20), dam_of(1), east).capacity());
}

TEST(Basin, BelowItsFootIsEmpty) {
  const Basin basin(channel(0.1, 20), dam_of(0.1), east);
  EXPECT_EQ(basin.capacity(), 0);
}

TEST(Basin, CountsWhatLiesBelowTheSill) {
  const Raster ground = channel(0.1, 20);
  const Basin basin(ground, dam_of(1), east);
  Columns columns(ground, 1, 1000);
  EXPECT_EQ(basin.measure(columns).filled, 0);
  EXPECT_EQ(basin.measure(columns).surface, basin.foot());
  std::vector<Vec3d> points;
  for (double x = -3.5; x < 3; ++x)  // 2 m deep, from 2.5 m upstream to 3.5 m downstream
    for (double y = -3.5; y < 4; ++y)
      for (const double z : {0.5, 1.5}) points.push_back({x, y, z + 0.1 * x});
  columns.update(cloud(points, 1000));
  const BasinState state = basin.measure(columns);
  // Half a cell of footprint besides: the columns at 1.5 and 2.5 hold no more than 0.85 and 0.75 m.
  EXPECT_GT(state.stored, 8 * (0.85 + 0.75) * 0.8);
  EXPECT_LT(state.stored, 10 * (0.85 + 0.75 + 0.65) + 1e-9);
  EXPECT_NEAR(state.filled, state.stored / basin.capacity(), 1e-12);
  EXPECT_NEAR(state.surface, 2.2, 0.3);
}

}  // namespace
}  // namespace sabo
