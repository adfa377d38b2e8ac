#include "terrain/polyline.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

const Polyline corner{{{0, 0, 10}, {10, 0, 20}, {10, 5, 30}}, true};

TEST(Polyline, LengthIsInPlan) { EXPECT_DOUBLE_EQ(length(corner), 15); }

TEST(Polyline, ProjectsOnThePieces) {
  const LinePlace first = project(corner, 4, 2);
  EXPECT_DOUBLE_EQ(first.station, 4);
  EXPECT_DOUBLE_EQ(first.offset, 2);
  const LinePlace second = project(corner, 12, 3);
  EXPECT_DOUBLE_EQ(second.station, 13);
  EXPECT_DOUBLE_EQ(second.offset, -2);
}

TEST(Polyline, OuterWedgeOfABendBelongsToItsVertex) {
  const LinePlace place = project(corner, 13, -4);
  EXPECT_DOUBLE_EQ(place.station, 10);
  EXPECT_DOUBLE_EQ(place.offset, -5);
}

TEST(Polyline, OuterWedgeOfASharpBendKeepsItsSide) {
  const Polyline hairpin{{{0, 0, 0}, {10, 0, 0}, {0, 5, 0}}, false};  // turns left by 153 degrees
  EXPECT_LT(project(hairpin, 12, 1).offset, 0);
  EXPECT_LT(project(hairpin, 12, -1).offset, 0);
}

TEST(Polyline, EndsGoOnStraight) {
  EXPECT_DOUBLE_EQ(project(corner, -3, 1).station, -3);
  EXPECT_DOUBLE_EQ(project(corner, -3, 1).offset, 1);
  EXPECT_DOUBLE_EQ(project(corner, 10.5, 9).station, 19);
  EXPECT_DOUBLE_EQ(project(corner, 10.5, 9).offset, -0.5);
  EXPECT_EQ(point_at(corner, -1), (Vec3d{-1, 0, 9}));
  EXPECT_EQ(point_at(corner, 16), (Vec3d{10, 6, 32}));
}

TEST(Polyline, PointsCarryInterpolatedHeight) {
  EXPECT_EQ(point_at(corner, 5), (Vec3d{5, 0, 15}));
  EXPECT_EQ(point_at(corner, 12.5), (Vec3d{10, 2.5, 25}));
  EXPECT_EQ(direction_at(corner, 5), (Vec3d{1, 0, 0}));
  EXPECT_EQ(direction_at(corner, 12), (Vec3d{0, 1, 0}));
}

TEST(Polyline, RepeatedVerticesAndShortLinesAreHarmless) {
  const Polyline repeated{{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 4, 0}},
                          false};
  EXPECT_DOUBLE_EQ(project(repeated, 5, 3).station, 7);
  EXPECT_EQ(point_at(repeated, 6), (Vec3d{4, 2, 0}));
  const Polyline single{{{1, 2, 3}}, true};
  EXPECT_DOUBLE_EQ(project(single, 4, 6).offset, 5);
  EXPECT_EQ(point_at(single, 7), (Vec3d{1, 2, 3}));
  EXPECT_EQ(project(Polyline{}, 1, 1).station, 0);
}

TEST(Polygon, HolesAreOutside) {
  const Polygon square{{{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}},
                        {{4, 4, 0}, {4, 6, 0}, {6, 6, 0}, {6, 4, 0}, {4, 4, 0}}}};
  EXPECT_DOUBLE_EQ(area(square), 96);
  EXPECT_TRUE(contains(square, 1, 9));
  EXPECT_FALSE(contains(square, 5, 5));
  EXPECT_TRUE(contains(square, 7, 5));
  EXPECT_FALSE(contains(square, 11, 5));
}

TEST(Polygon, AreaKeepsItsDigitsFarFromTheOrigin) {
  const double x = 5e5;
  const double y = 4e6;
  const Polygon triangle{{{{x, y, 0}, {x + 0.1, y, 0}, {x, y + 0.1, 0}}}};
  EXPECT_NEAR(area(triangle), 0.005, 1e-10);
}

}  // namespace
}  // namespace sabo
