#include "physics/pair/viscous_flux.hpp"

#include <random>

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(EigenvalueBound, IsTheEigenvalueWhereAllAreAlike) {
  EXPECT_DOUBLE_EQ(eigenvalue_bound(isotropic(3.0), 3), 3);
  EXPECT_DOUBLE_EQ(eigenvalue_bound({3, 0, 0, 0, 0, 3}, 2), 3);
}

// (2 1; 1 2) has the eigenvalues 1 and 3.
TEST(EigenvalueBound, IsTheGreaterOneOfTwo) {
  EXPECT_DOUBLE_EQ(eigenvalue_bound({2, 0, 1, 0, 0, 2}, 2), 3);
}

// Of (1, 2, 6): mean 3, variance 14/3.
TEST(EigenvalueBound, IsAMeanAndADeviation) {
  EXPECT_DOUBLE_EQ(eigenvalue_bound({1, 0, 0, 2, 0, 6}, 3), 3 + std::sqrt(28.0 / 3));
}

TEST(EigenvalueBound, IsNotExceededByAnyDirection) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vec3d{u(random), u(random), u(random)}; };
  for (int trial = 0; trial < 200; ++trial) {
    const Sym3<double> a =
        scaled_square(1.0, vector()) + scaled_square(0.1, vector()) + scaled_square(2.0, vector());
    const double bound = eigenvalue_bound(a, 3);
    for (int k = 0; k < 20; ++k) {
      const Vec3d n = normalised(vector());
      EXPECT_LE(dot(n, a * n), bound);
    }
  }
}

TEST(InverseRoot, IsThatOfAnIsotropicTensor) {
  EXPECT_EQ(inverse_root(isotropic(4.0), 3), isotropic(0.5));
}

TEST(InverseRoot, IsNoneWithoutViscosity) { EXPECT_EQ(inverse_root({}, 3), (Sym3<double>{})); }

// (5 3; 3 5)/8 has the eigenvalues 1, along (1, 1), and 1/4, along (1, -1), of which the series
// 1 + 3/8 + 27/128 has 1.5859 in place of 2.
TEST(InverseRoot, FallsShortWhereATensorIsNotIsotropic) {
  const Sym3<double> root = inverse_root({0.625, 0, 0.375, 0, 0, 0.625}, 2);
  EXPECT_NEAR(root.xx, (1 + 1.5859375) / 2, 1e-14);
  EXPECT_NEAR(root.xz, (1 - 1.5859375) / 2, 1e-14);
}

// S C S is at most 1: what the gradient takes back is never more than the pairs give.
TEST(InverseRoot, IsNeverTooGreat) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vec3d{u(random), u(random), u(random)}; };
  for (int trial = 0; trial < 200; ++trial) {
    const Sym3<double> c = scaled_square(1.0, vector()) + scaled_square(0.3, vector());
    const Sym3<double> s = inverse_root(c, 3);
    for (int k = 0; k < 20; ++k) {
      const Vec3d n = s * normalised(vector());
      EXPECT_LE(dot(n, c * n), 1 + 1e-12);
    }
  }
}

TEST(HalfGradient, IsScaledFromBothSides) {
  const VelocityGradient<double> b{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const VelocityGradient<double> half = half_gradient(b, {2, 0, 0, 1, 0, 3});
  EXPECT_EQ(half.x, (Vec3d{2, 2, 9}));  // 4/2, 4/2, 18/2
  EXPECT_EQ(half.y, (Vec3d{4, 2.5, 9}));
  EXPECT_EQ(half.z, (Vec3d{21, 12, 40.5}));
}

TEST(VelocityGradient, AddsUpOuterProducts) {
  VelocityGradient<double> b{{1, 0, 0}, {}, {}};
  b += outer_product(Vec3d{1, -1, 3}, Vec3d{2, 4, 0});
  EXPECT_EQ(b.x, (Vec3d{3, 4, 0}));
  EXPECT_EQ(b.y, (Vec3d{-2, -4, 0}));
  EXPECT_EQ(b.z, (Vec3d{6, 12, 0}));
}

// A simple shear v_x = z: the velocity changes along z, its transposed one carries z along x.
TEST(VelocityGradient, IsTransposed) {
  const VelocityGradient<double> shear{{0, 0, 1}, {}, {}};
  EXPECT_EQ(transposed_times(shear, Vec3d{5, 0, 0}), (Vec3d{0, 0, 5}));
  EXPECT_EQ(transposed_times(shear, Vec3d{0, 0, 5}), (Vec3d{}));
}

}  // namespace
}  // namespace sabo
