#include "terrain/valley.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "rasters.hpp"
#include <gtest/gtest.h>

#include "math/angle.hpp"
#include "terrain/surface.hpp"

namespace sabo {
namespace {

TEST(Valley, BedHasThePublishedSlopes) {
  const double places[] = {0, 60, 150, 300, 500, 650, 800, 1200};
  const double angles[] = {33, 33, 24, 18, 14, 10, 6, 4};
  for (int k = 0; k < 8; ++k) {
    EXPECT_DOUBLE_EQ(valley_slope(places[k]), angles[k]);
    const double step = 1e-4;
    const double fall = (valley_bed(places[k] - step) - valley_bed(places[k] + step)) / (2 * step);
    EXPECT_NEAR(std::atan(fall) / degree, angles[k], 1e-4);
  }
}

TEST(Valley, BedIsTheIntegralOfItsSlope) {
  double z = 250;
  const double step = 0.01;
  for (double x = 0; x < 1000 - step / 2; x += step) {
    z -= step * std::tan(valley_slope(x + step / 2) * degree);
  }
  EXPECT_DOUBLE_EQ(valley_bed(0), 250);
  EXPECT_NEAR(valley_bed(1000), z, 1e-4);
}

TEST(Valley, CrossSectionIsABedBetweenSides) {
  const double axis = valley_axis(400);
  EXPECT_NEAR(axis, 12 * std::sin(2 * std::numbers::pi * 400 / 420), 1e-12);
  EXPECT_DOUBLE_EQ(valley_elevation(400, axis + 5.9), valley_bed(400));
  // 10 m from the edge of the bed: 0.55 * 100 / 18.
  EXPECT_NEAR(valley_elevation(400, axis - 16) - valley_bed(400), 55.0 / 18, 1e-9);
  // On the fan the bed is 6 + 0.12 * 350 = 48 m wide to either side.
  EXPECT_DOUBLE_EQ(valley_elevation(1000, valley_axis(1000) + 47.9), valley_bed(1000));
  EXPECT_GT(valley_elevation(1000, valley_axis(1000) + 49), valley_bed(1000));
}

TEST(Valley, DemSamplesTheGround) {
  const Raster dem = valley_dem(2);
  const Surface surface(dem);
  EXPECT_TRUE(surface.inside(0, -80));
  EXPECT_TRUE(surface.inside(1200, 80));
  EXPECT_DOUBLE_EQ(surface.height(600, 10), valley_elevation(600, 10));
}

TEST(Valley, SourceHoldsItsVolume) {
  const ReleaseShape shape = valley_release();
  double volume = 0;
  const double step = 0.1;
  double deepest = 0;
  for (double x = shape.west + step / 2; x < shape.east; x += step) {
    for (double y = shape.south + step / 2; y < shape.north; y += step) {
      volume += shape.thickness(x, y) * step * step;
      deepest = std::max(deepest, shape.thickness(x, y));
    }
  }
  EXPECT_EQ(shape.volume, 8863);
  EXPECT_NEAR(volume, 8863, 9);
  EXPECT_NEAR(deepest, 5, 0.01);
  EXPECT_EQ(shape.thickness(24.9, valley_axis(24.9)), 0);
}

TEST(Valley, DamSpansTheChannel) {
  const CheckDam dam = valley_dam();
  EXPECT_DOUBLE_EQ(dam.crest, valley_bed(620) + 8);
  for (const Vec3d& end : dam.axis.vertices) {
    EXPECT_GT(valley_elevation(end.x, end.y), dam.crest);
  }
  const Vec3d middle = point_at(dam.axis, dam.notch->centre);
  EXPECT_NEAR(middle.x, 620, 1e-9);
  EXPECT_NEAR(middle.y, valley_axis(620), 1e-9);
  EXPECT_DOUBLE_EQ(dam.top(dam.notch->centre), dam.crest - 1.5);
  // Upstream is to the left of the line, so that discharge counts positive downstream.
  EXPECT_GT(project(dam.axis, 600, valley_axis(600)).offset, 0);
  // Perpendicular to the channel.
  const double tilt = valley_axis(620.01) - valley_axis(619.99);
  EXPECT_NEAR(dot(direction_at(dam.axis, 1), normalised(Vec3d{0.02, tilt, 0})), 0, 1e-4);
}

TEST(Valley, PathFollowsTheAxis) {
  const Polyline path = valley_path();
  EXPECT_EQ(path.vertices.size(), 241U);
  EXPECT_EQ(path.vertices[60], (Vec3d{300, valley_axis(300), valley_bed(300)}));
}

}  // namespace
}  // namespace sabo
