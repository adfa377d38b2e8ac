#include "io/output/camera.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "io/output/depth_canvas.hpp"
#include "math/angle.hpp"

namespace sabo {
namespace {

TEST(Camera, ProjectsByEqualTriangles) {
  Camera camera;  // looks north
  camera.place = {0, 0, 10};
  camera.focal = 100;
  camera.centre_x = 50;
  camera.centre_y = 40;
  // 20 m ahead, 2 m to the right and 5 m below: 100/20 px for a metre.
  const Projected p = camera.project({2, 20, 5});
  EXPECT_DOUBLE_EQ(p.distance, 20);
  EXPECT_DOUBLE_EQ(p.x, 60);
  EXPECT_DOUBLE_EQ(p.y, 65);
  EXPECT_LT(camera.project({0, -1, 0}).distance, 0);
}

TEST(CameraAround, LooksWhereItIsToldTo) {
  const std::vector<Vec3d> points{{0, 10, 0}, {0, -10, 0}};
  const Camera east = camera_around(points, {90, 0}, 200, 100, 1);
  // North is to the left; the points stand at the margins of 5 %.
  EXPECT_NEAR(east.project(points[0]).x, 10, 1e-9);
  EXPECT_NEAR(east.project(points[1]).x, 190, 1e-9);
  EXPECT_NEAR(east.project(points[0]).y, 50, 1e-9);
  EXPECT_NEAR(east.project(points[0]).distance, 10 / (0.9 * std::tan(20 * degree)), 1e-9);
  const Camera plan = camera_around(points, {0, 90}, 200, 100, 1);
  EXPECT_NEAR(plan.project(points[0]).y, 5, 1e-9);  // north is up
  EXPECT_NEAR(plan.project(points[1]).y, 95, 1e-9);
}

RC_GTEST_PROP(CameraAround, HoldsAllPointsFromAnyDirection, ()) {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) * 0.1; };
  std::vector<Vec3d> points;
  for (int k = *rc::gen::inRange(1, 20); k > 0; --k) {
    points.push_back({6e5 + number(-5000, 5000), 4e6 + number(-5000, 5000), number(-900, 900)});
  }
  const LookDirection direction{number(0, 3600), number(0, 900)};
  const Camera camera = camera_around(points, direction, 1100, 720, 2);
  for (const Vec3d& point : points) {
    const Projected p = camera.project(point);
    RC_ASSERT(p.distance > 2 - 1e-6);
    RC_ASSERT(p.x > 0.05 * 1100 - 1e-3 && p.x < 0.95 * 1100 + 1e-3);
    RC_ASSERT(p.y > 0.05 * 720 - 1e-3 && p.y < 0.95 * 720 + 1e-3);
  }
}

// A triangle over the whole canvas of 20 x 20, seen from above, at one distance.
std::array<CanvasCorner, 3> sheet(double distance, float value) {
  std::array<CanvasCorner, 3> corners{
      {{.x = -100, .y = -100}, {.x = -100, .y = 200}, {.x = 200, .y = -100}}};
  for (CanvasCorner& corner : corners) {
    corner.nearness = 1 / distance;
    corner.value = value;
  }
  return corners;
}

TEST(DepthCanvas, KeepsTheNearestWhateverTheOrder) {
  const auto near = sheet(10, 1), far = sheet(11, 2);
  for (const bool near_first : {true, false}) {
    DepthCanvas canvas(20, 20);
    const auto& first = near_first ? near : far;
    const auto& second = near_first ? far : near;
    canvas.draw_ground(first[0], first[1], first[2]);
    canvas.draw_ground(second[0], second[1], second[2]);
    EXPECT_EQ(canvas.at(5, 5).value, 1);
    EXPECT_TRUE(canvas.shows(5, 5, 1 / 9.9));
    EXPECT_TRUE(canvas.shows(5, 5, 1 / 10.0));
    EXPECT_FALSE(canvas.shows(5, 5, 1 / 11.0));
    EXPECT_FALSE(canvas.shows(-1, 5, 1));
  }
}

TEST(DepthCanvas, ValuesFollowThePlaneAndNotThePicture) {
  DepthCanvas canvas(20, 20);
  // From 0 at a distance of 1 to 8 at a distance of 3. Halfway on the picture the nearness is 2/3,
  // the distance 1.5: a quarter of the way on the plane.
  const CanvasCorner a{.x = 0.5, .y = -40, .nearness = 1, .value = 0};
  const CanvasCorner b{.x = 0.5, .y = 60, .nearness = 1, .value = 0};
  const CanvasCorner c{.x = 20.5, .y = 10, .nearness = 1.0 / 3, .value = 8};
  canvas.draw_ground(a, b, c);
  EXPECT_FLOAT_EQ(canvas.at(10, 10).nearness, 2.0f / 3);
  EXPECT_FLOAT_EQ(canvas.at(10, 10).value, 2);
}

TEST(DepthCanvas, TellsGroundFlowAndEarthApart) {
  DepthCanvas canvas(20, 20);
  auto corners = sheet(10, 0);
  canvas.draw_ground(corners[0], corners[1], corners[2]);
  EXPECT_EQ(canvas.at(5, 5).shown, Shown::ground);
  for (CanvasCorner& corner : corners) {
    corner.wetness = 1;
    corner.nearness = 1 / 9.0;
  }
  canvas.draw_ground(corners[0], corners[1], corners[2]);
  EXPECT_EQ(canvas.at(5, 5).shown, Shown::flow);
  const auto from_below = sheet(8, 0);
  canvas.draw_ground(from_below[0], from_below[2], from_below[1]);
  EXPECT_EQ(canvas.at(5, 5).shown, Shown::earth);
}

TEST(DepthCanvas, TwoTrianglesLeaveNoGapBetweenThem) {
  DepthCanvas canvas(100, 100);
  const CanvasCorner a{.x = 0.1, .y = 0.2, .nearness = 1}, b{.x = 3.7, .y = 99.9, .nearness = 0.3};
  const CanvasCorner c{.x = 99.7, .y = 98.3, .nearness = 0.7},
      d{.x = 97.9, .y = 0.3, .nearness = 1};
  canvas.draw_ground(a, b, c);
  canvas.draw_ground(a, c, d);
  for (int k = 1; k < 98; ++k) EXPECT_NE(canvas.at(k, k).shown, Shown::nothing) << k;
}

TEST(DepthCanvas, LeavesOutWhatHasNoPlace) {
  DepthCanvas canvas(20, 20);
  auto corners = sheet(10, 0);
  corners[1].x = std::nan("");
  canvas.draw_ground(corners[0], corners[1], corners[2]);
  corners[1].x = HUGE_VAL;
  canvas.draw_ground(corners[0], corners[1], corners[2]);
  corners[1] = corners[0];
  canvas.draw_ground(corners[0], corners[1], corners[2]);
  EXPECT_EQ(canvas.at(5, 5).shown, Shown::nothing);
}

}  // namespace
}  // namespace sabo
