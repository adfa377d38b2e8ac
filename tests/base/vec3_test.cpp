#include "math/vec3.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sabo {
namespace {

using Vec3i = Vec3<int>;  // exact, so that laws hold without tolerance

Vec3i small_vector() {
  const auto component = rc::gen::inRange(-1000, 1000);
  return {*component, *component, *component};
}

TEST(Vec3, AddsAndScalesByComponents) {
  Vec3d a{1, 2, 3};
  const Vec3d b{10, 20, 30};
  EXPECT_EQ(a + b, (Vec3d{11, 22, 33}));
  EXPECT_EQ(b - a, (Vec3d{9, 18, 27}));
  EXPECT_EQ(-a, (Vec3d{-1, -2, -3}));
  EXPECT_EQ(2.0 * a, (Vec3d{2, 4, 6}));
  EXPECT_EQ(a * 2.0, 2.0 * a);
  a += b;
  a -= Vec3d{1, 1, 1};
  a *= 0.5;
  EXPECT_EQ(a, (Vec3d{5, 10.5, 16}));
}

TEST(Vec3, IsZeroFirst) { EXPECT_EQ(Vec3d{}, (Vec3d{0, 0, 0})); }

TEST(Vec3, DotAndNorm) {
  EXPECT_EQ(dot(Vec3d{1, 2, 3}, Vec3d{4, -5, 6}), 12);
  EXPECT_EQ(norm(Vec3d{2, 3, 6}), 7);
  EXPECT_EQ(normalised(Vec3d{0, 0, -4}), (Vec3d{0, 0, -1}));
}

TEST(Vec3, CrossIsRightHanded) {
  EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
  EXPECT_EQ(cross(Vec3d{0, 1, 0}, Vec3d{0, 0, 1}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(cross(Vec3d{1, 2, 3}, Vec3d{4, 5, 6}), (Vec3d{-3, 6, -3}));
}

RC_GTEST_PROP(Vec3, CrossIsNormalToBothAndLagrangeHolds, ()) {
  const Vec3i a = small_vector();
  const Vec3i b = small_vector();
  const Vec3i c = cross(a, b);
  RC_ASSERT(cross(b, a) == -c);
  using Wide = Vec3<long long>;
  const Wide wide{c.x, c.y, c.z};
  RC_ASSERT(dot(wide, Wide{a.x, a.y, a.z}) == 0);
  RC_ASSERT(dot(wide, Wide{b.x, b.y, b.z}) == 0);
  const long long aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
  RC_ASSERT(dot(wide, wide) == aa * bb - ab * ab);
}

}  // namespace
}  // namespace sabo
