#include "terrain/terrain_edit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "terrain/cells_within.hpp"
#include "terrain/dem_difference.hpp"
#include "terrain/rasters.hpp"

namespace sabo {
namespace {

/// 10 x 10 cells of 1 m from (0, 0), z = x of the cell's centre.
Raster ramp() {
  return raster_of(Grid{10, 10, 0, 10, 1, 1}, [](double x, double) { return x; });
}

TEST(CellsWithin, AreThoseWhoseCentresLieInside) {
  const Grid grid{10, 10, 0, 10, 1, 1};
  EXPECT_EQ(cells_within(grid, {square(2, 5)}).size(), 9u);
  EXPECT_EQ(cells_within(grid, {square(2, 5), square(4, 6)}).size(), 12u) << "one is in both";
  EXPECT_TRUE(cells_within(grid, {square(2.6, 3.4)}).empty());
  EXPECT_EQ(cells_within(grid, {square(-50, 50)}).size(), 100u);
  EXPECT_TRUE(cells_within(grid, {square(20, 30)}).empty());
}

TEST(TerrainEdit, SetsAnElevation) {
  Raster ground = ramp();
  // Columns 2, 3 and 4 at 2.5, 3.5 and 4.5 m become 3 m: three cells each.
  const EditReport report = apply({"pad", {square(2, 5)}, SetElevation{3}}, ground);
  EXPECT_EQ(report.cells, 9u);
  EXPECT_DOUBLE_EQ(report.fill, 3 * 0.5);
  EXPECT_DOUBLE_EQ(report.cut, 3 * (0.5 + 1.5));
  EXPECT_DOUBLE_EQ(report.greatest, 1.5);
  EXPECT_EQ(ground.at(3, 6), 3);
  EXPECT_EQ(ground.at(3, 1), 3.5) << "outside";
}

TEST(TerrainEdit, ShiftsUpAndDown) {
  Raster ground = ramp();
  const EditReport lowered = apply({"channel", {square(2, 5)}, ShiftElevation{-2}}, ground);
  EXPECT_DOUBLE_EQ(lowered.cut, 18);
  EXPECT_EQ(lowered.fill, 0);
  apply({"bank", {square(2, 5)}, ShiftElevation{2}}, ground);
  EXPECT_EQ(ground.values, ramp().values);
}

TEST(TerrainEdit, SmoothsToTheMeanOfACircle) {
  Raster ground(Grid{10, 10, 0, 10, 1, 1}, 5);
  ground.at(4, 5) = 10;
  // Radius 1: the cell and its four neighbours, mean (10 + 4 x 5) / 5 = 6; beside it the same.
  apply({"smooth", {square(0, 10)}, SmoothElevation{1}}, ground);
  EXPECT_DOUBLE_EQ(ground.at(4, 5), 6);
  EXPECT_DOUBLE_EQ(ground.at(5, 5), 6);
  EXPECT_DOUBLE_EQ(ground.at(5, 6), 5) << "1.41 m away";
}

TEST(TerrainEdit, SmoothingLeavesAPlaneAsItIsAwayFromTheEdge) {
  Raster ground = ramp();
  apply({"smooth", {square(3, 7)}, SmoothElevation{2.9}}, ground);
  for (int column = 3; column < 7; ++column) EXPECT_NEAR(ground.at(column, 5), column + 0.5, 1e-12);
}

// 17 x 0.1 is a rounding above 1.7, and 0.3/0.1 one below 3.
TEST(TerrainEdit, SmoothingTakesTheCellsAtTheRadiusWhateverTheRounding) {
  Raster ground(Grid{61, 61, 0, 6.1, 0.1, 0.1}, 5);
  ground.at(30, 30) = 5 + 29;
  // A circle of radius 3 cells holds 29 of them.
  apply({"smooth", {square(0, 6.1)}, SmoothElevation{0.3}}, ground);
  EXPECT_NEAR(ground.at(30, 27), 6, 1e-12);
  EXPECT_NEAR(ground.at(30, 26), 5, 1e-12);
  for (const double radius : {1.7, 3.4, 7.3}) {
    const EditReport report = apply({"smooth", {square(0, 6.1)}, SmoothElevation{radius}}, ground);
    EXPECT_TRUE(std::isfinite(report.fill)) << radius;
  }
}

TEST(TerrainEdit, LeavesCellsWithoutDataAlone) {
  Raster ground = ramp();
  ground.at(3, 5) = Raster::no_data;
  const EditReport report = apply({"pad", {square(2, 5)}, SetElevation{3}}, ground);
  EXPECT_EQ(report.cells, 8u);
  EXPECT_TRUE(std::isnan(ground.at(3, 5)));
  ground.at(7, 5) = Raster::no_data;
  apply({"smooth", {square(0, 10)}, SmoothElevation{1}}, ground);
  EXPECT_TRUE(std::isnan(ground.at(7, 5)));
  EXPECT_DOUBLE_EQ(ground.at(8, 5), (8.5 + 9.5 + 8.5 + 8.5) / 4) << "the gap does not count";
}

/// After: a bowl of 2 m in the middle of flat ground at 5 m, on cells of 2 m.
DemPair bowl() {
  const Grid coarse{10, 10, -5, 15, 2, 2};
  return {Raster(coarse, 5), raster_of(coarse, [](double x, double y) {
            return std::abs(x - 5) < 3 && std::abs(y - 5) < 3 ? 3.0 : 5.0;
          })};
}

TEST(DemDifference, IsWhatWasLostAboveTheNoise) {
  const Raster ground(Grid{10, 10, 0, 10, 1, 1}, 5);
  // Cells of the pair have their centres at 2, 4, 6, 8 m; those at 4 and 6 are 2 m lower. At 4.5 m
  // both neighbours are low: 2 m. At 3.5 m three quarters: 1.5 m.
  const Raster lost = lost_thickness(bowl(), ground, {}, 0);
  EXPECT_DOUBLE_EQ(lost.at(4, 5), 2);
  EXPECT_DOUBLE_EQ(lost.at(3, 5), 1.5);
  EXPECT_TRUE(std::isnan(lost.at(0, 5))) << "nothing was lost there";
  EXPECT_TRUE(std::isnan(lost_thickness(bowl(), ground, {}, 1.6).at(3, 5)));
  const Raster within = lost_thickness(bowl(), ground, {square(4, 5)}, 0);
  EXPECT_DOUBLE_EQ(within.at(4, 5), 2);
  EXPECT_TRUE(std::isnan(within.at(5, 5)));
}

TEST(DemDifference, AHoleCostsOnlyItsOwnCell) {
  const Raster ground(Grid{10, 10, 0, 10, 1, 1}, 5);
  DemPair pair{Raster(ground.grid, 5), Raster(ground.grid, 3)};
  pair.after.at(4, 5) = Raster::no_data;
  const Raster lost = lost_thickness(pair, ground, {}, 0);
  int missing = 0;
  for (const double thickness : lost.values) missing += std::isnan(thickness);
  EXPECT_EQ(missing, 1);
  Raster holed = ground;
  holed.at(0, 0) = Raster::no_data;
  EXPECT_TRUE(std::isnan(lost_thickness(pair, holed, {}, 0).at(0, 0))) << "no ground, no release";
}

TEST(DemDifference, GroundIsLoweredOnlyWhereSomethingWasLost) {
  Raster ground(Grid{10, 10, 0, 10, 1, 1}, 5);
  const Raster lost = lost_thickness(bowl(), ground, {square(4, 6)}, 0);
  EXPECT_DOUBLE_EQ(lower_to_after(bowl(), lost, ground), 8) << "4 cells by 2 m";
  EXPECT_EQ(ground.at(4, 5), 3);
  EXPECT_EQ(ground.at(3, 5), 5);
  EXPECT_EQ(lower_to_after(bowl(), lost, ground), 0) << "it is there already";
}

}  // namespace
}  // namespace sabo
