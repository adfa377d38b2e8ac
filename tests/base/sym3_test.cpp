#include "math/sym3.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sabo {
namespace {

using Vec3i = Vec3<int>;
using Sym3i = Sym3<int>;

int small() { return *rc::gen::inRange(-100, 100); }  // no product overflows
Vec3i smaller_vector() { return {small(), small(), small()}; }
Sym3i small_tensor() { return {small(), small(), small(), small(), small(), small()}; }

// | 1 2 3 |
// | 2 4 5 |
// | 3 5 6 |
constexpr Sym3<double> tensor{1, 2, 3, 4, 5, 6};

TEST(Sym3, TimesAVectorIsRowByRow) {
  EXPECT_EQ((tensor * Vec3d{1, 0, 0}), (Vec3d{1, 2, 3}));
  EXPECT_EQ((tensor * Vec3d{0, 1, 0}), (Vec3d{2, 4, 5}));
  EXPECT_EQ((tensor * Vec3d{1, 10, 100}), (Vec3d{321, 542, 653}));
}

TEST(Sym3, AddsAndScalesByComponents) {
  EXPECT_EQ(tensor + tensor, 2.0 * tensor);
  EXPECT_EQ(3.0 * tensor, (Sym3<double>{3, 6, 9, 12, 15, 18}));
}

TEST(Sym3, TraceAndIsotropic) {
  EXPECT_EQ(trace(tensor), 11);
  EXPECT_EQ(trace(isotropic(5.0)), 15);
  EXPECT_EQ((isotropic(5.0) * Vec3d{1, 2, 3}), (Vec3d{5, 10, 15}));
}

TEST(Sym3, DoubleDotCountsTheOffDiagonalTwice) {
  EXPECT_EQ(double_dot(tensor, tensor), 1 + 16 + 36 + 2 * (4 + 9 + 25));
  EXPECT_EQ(double_dot(tensor, isotropic(1.0)), trace(tensor));
}

TEST(Sym3, SymmetricProductByHand) {
  EXPECT_EQ((symmetric_product(Vec3d{1, 2, 3}, Vec3d{4, 5, 6})),
            (Sym3<double>{8, 13, 18, 20, 27, 36}));
}

RC_GTEST_PROP(Sym3, IsSymmetricAndLinear, ()) {
  const Sym3i a = small_tensor();
  const Sym3i b = small_tensor();
  const Vec3i u = smaller_vector();
  const Vec3i v = smaller_vector();
  RC_ASSERT(dot(u, a * v) == dot(a * u, v));
  RC_ASSERT((a + b) * v == a * v + b * v);
  RC_ASSERT(double_dot(a, b) == double_dot(b, a));
}

RC_GTEST_PROP(Sym3, SymmetricProductActsLikeItsDyads, ()) {
  const Vec3i a = smaller_vector();
  const Vec3i b = smaller_vector();
  const Vec3i v = smaller_vector();
  RC_ASSERT(symmetric_product(a, b) * v == dot(b, v) * a + dot(a, v) * b);
  RC_ASSERT(trace(symmetric_product(a, b)) == 2 * dot(a, b));
}

}  // namespace
}  // namespace sabo
