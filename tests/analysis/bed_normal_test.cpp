#include "analysis/bed_normal.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(BedNormalThickness, IsTheDepthByTheCosineOfTheSlope) {
  // 3 in 4 along x: the cosine is 4/5, at the edges too.
  Raster ground(Grid{4, 3, 0, 6, 2, 2});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      ground.values[ground.grid.index(column, row)] = 0.75 * ground.grid.x_of(column);
  Raster depth(ground.grid);
  depth.values.assign(depth.values.size(), 10);
  for (const double thickness : bed_normal_thickness(depth, ground).values)
    EXPECT_NEAR(thickness, 8, 1e-12);
}

TEST(BedNormalThickness, LeavesCellsWithoutGroundOut) {
  Raster ground(Grid{3, 1, 0, 1, 1, 1});
  ground.values = {0, Raster::no_data, 5};
  Raster depth(ground.grid);
  depth.values = {1, Raster::no_data, 2};
  const Raster thickness = bed_normal_thickness(depth, ground);
  EXPECT_EQ(thickness.values[0], 1) << "no neighbour to slope to";
  EXPECT_TRUE(std::isnan(thickness.values[1]));
  EXPECT_EQ(thickness.values[2], 2);
}

}  // namespace
}  // namespace sabo
