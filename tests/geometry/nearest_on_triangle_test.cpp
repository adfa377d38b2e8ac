#include "geometry/nearest_on_triangle.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(NearestOnTriangle, CornersEdgesAndFace) {
  const auto nearest = [](const Vec3d& point) {
    return nearest_on_triangle(point, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  };
  EXPECT_EQ(nearest({1, 1, 5}), (Vec3d{1, 1, 0}));
  EXPECT_EQ(nearest({2, -3, 1}), (Vec3d{2, 0, 0}));
  EXPECT_EQ(nearest({-3, 2, 1}), (Vec3d{0, 2, 0}));
  EXPECT_EQ(nearest({-2, -3, 1}), (Vec3d{0, 0, 0}));
  EXPECT_EQ(nearest({4, 4, 0}), (Vec3d{2, 2, 0}));
  EXPECT_EQ(nearest({9, 1, 0}), (Vec3d{4, 0, 0}));
  EXPECT_EQ(nearest({1, 9, 0}), (Vec3d{0, 4, 0}));
}

}  // namespace
}  // namespace sabo
