#include "terrain/steepest_descent.hpp"

#include <cmath>

#include "rasters.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "terrain/pit_filling.hpp"

namespace sabo {
namespace {

/// A valley that falls to the east, with sides, a pit and a dam across it.
Raster valley_with_pit() {
  return raster_of(square_grid(-50, 50, 1), [](double x, double y) {
    double z = -0.2 * x + 0.02 * y * y;
    if (std::hypot(x, y) < 6) z -= 5;
    if (std::abs(x - 25) < 1.5) z = std::max(z, 3.0);
    return z;
  });
}

TEST(PitFilling, RaisesPitsOnly) {
  const Raster raster = valley_with_pit();
  const Raster filled = pits_filled(raster);
  const Grid& grid = raster.grid;
  for (int row = 1; row + 1 < grid.rows; ++row) {
    for (int column = 1; column + 1 < grid.columns; ++column) {
      EXPECT_GE(filled.at(column, row), raster.at(column, row));
      double lowest = 1e9;
      for (int down = -1; down <= 1; ++down) {
        for (int right = -1; right <= 1; ++right) {
          if (right == 0 && down == 0) continue;
          lowest = std::min(lowest, filled.at(column + right, row + down));
        }
      }
      EXPECT_LT(lowest, filled.at(column, row));
    }
  }
  EXPECT_EQ(filled.at(grid.column_of(-30), grid.row_of(5)),
            raster.at(grid.column_of(-30), grid.row_of(5)));
}

TEST(SteepestDescent, LeavesAPitAndPassesADam) {
  const Polyline path = steepest_descent(valley_with_pit(), -40, 8);
  EXPECT_TRUE(path.has_z);
  EXPECT_EQ(path.vertices.front(), (Vec3d{-40, 8, 0.2 * 40 + 0.02 * 64}));
  EXPECT_NEAR(path.vertices.back().x, 50, 1);
  for (const Vec3d& vertex : path.vertices) {
    EXPECT_TRUE(std::isfinite(vertex.z));
    EXPECT_LT(std::abs(vertex.y), 8.5);
  }
}

TEST(SteepestDescent, IsAboutAsLongAsTheWay) {
  // A straight valley in a direction between those of the grid.
  const Raster valley = raster_of(square_grid(0, 200, 1), [](double x, double y) {
    const double along = 0.9 * x + 0.44 * y;
    const double across = 0.44 * x - 0.9 * y;
    return -0.2 * along + 0.3 * std::abs(across);
  });
  const Polyline path = steepest_descent(valley, 20, 9.8);
  const Vec3d whole = path.vertices.back() - path.vertices.front();
  EXPECT_NEAR(path.vertices.back().x, 200, 1);
  EXPECT_LT(length(path), 1.02 * std::hypot(whole.x, whole.y));
}

TEST(SteepestDescent, StopsWhereItFirstReachesTheBorder) {
  const Raster plane =
      raster_of(square_grid(0, 200, 1), [](double x, double y) { return -0.3 * x - 0.12 * y; });
  const Polyline path = steepest_descent(plane, 10, 50);
  EXPECT_NEAR(path.vertices.back().x, 200, 1);
  EXPECT_NEAR(path.vertices.back().y, 50, 1);  // due east is the steepest of eight directions
}

TEST(SteepestDescent, CrossesAFlatFloorAtSeaLevel) {
  const Polyline path = steepest_descent(Raster(square_grid(0, 20, 1), 0), 9, 10);
  EXPECT_GT(length(path), 8);
}

TEST(SteepestDescent, EndsAtTheLowestPlaceOfABowl) {
  const Raster bowl =
      raster_of(square_grid(-20, 20, 1), [](double x, double y) { return 0.1 * (x * x + y * y); });
  const Polyline path = steepest_descent(bowl, -15, 4);
  EXPECT_EQ(path.vertices.back(), Vec3d{});
}

TEST(SteepestDescent, RefusesAStartOutside) {
  EXPECT_THROW(steepest_descent(valley_with_pit(), 80, 0), CaseError);
  Raster raster(square_grid(0, 5, 1), 1);
  raster.at(2, 2) = Raster::no_data;
  EXPECT_THROW(steepest_descent(raster, 2, 3), CaseError);
}

}  // namespace
}  // namespace sabo
