#include "terrain/tilted_plane.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "math/angle.hpp"
#include "terrain/surface.hpp"

namespace sabo {
namespace {

TEST(TiltedPlane, CoversItsRectangleAndFallsAsGiven) {
  const double azimuth = 120 * degree;
  const TiltedPlane plane{10, 20, 13, 24.1, 100, 0.25, azimuth};
  const Surface surface(raster_of(plane, 0.5));
  EXPECT_TRUE(surface.inside(10.001, 20.001));
  EXPECT_TRUE(surface.inside(12.999, 24.099));
  EXPECT_FALSE(surface.inside(9.99, 22));
  EXPECT_FALSE(surface.inside(11, 24.11));
  // It falls to the east and, half as much over root 3, to the south: the lowest corner is there.
  EXPECT_NEAR(surface.height(12.9999, 20.0001), 100, 1e-3);
  const double east = 0.25 * std::sin(azimuth), north = 0.25 * std::cos(azimuth);
  EXPECT_NEAR(surface.height(11, 22) - surface.height(12, 22), east, 1e-9);
  EXPECT_NEAR(surface.height(11, 22) - surface.height(11, 23), north, 1e-9);
}

TEST(TiltedPlane, HasCellsOfAtMostTheSizeAsked) {
  const Raster raster = raster_of({0, 0, 3, 0.9, 0, 0, 0}, 0.5);
  EXPECT_EQ(raster.grid.columns, 7);
  EXPECT_EQ(raster.grid.dx, 0.5);
  EXPECT_EQ(raster.grid.rows, 3);
  EXPECT_EQ(raster.grid.dy, 0.45);
}

}  // namespace
}  // namespace sabo
