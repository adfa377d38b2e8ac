#include "physics/kernel.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

// Midpoint rule over the support: volume element 2 pi r dr in two, 4 pi r^2 dr in three dimensions.
double integral(const WendlandC2<double>& kernel, int dimension) {
  constexpr int steps = 20000;
  const double dr = kernel.radius() / steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double r = (k + 0.5) * dr;
    sum += kernel.value(r) * (dimension == 2 ? 2 * M_PI * r : 4 * M_PI * r * r) * dr;
  }
  return sum;
}

TEST(WendlandC2, IntegratesToOneInTwoAndThreeDimensions) {
  for (const int dimension : {2, 3})
    for (const double h : {0.01, 1.125})
      EXPECT_NEAR(integral(WendlandC2<double>::make(h, dimension), dimension), 1, 1e-8);
}

TEST(WendlandC2, HasThePublishedValues) {
  const auto kernel = WendlandC2<double>::make(2.0, 3);  // a_D = 21/(16 pi 8)
  EXPECT_DOUBLE_EQ(kernel.value(0), 21 / (128 * M_PI));
  EXPECT_DOUBLE_EQ(kernel.value(2.0), 21 / (128 * M_PI) * 3 / 16.0);  // q = 1: (1/2)^4 x 3
  EXPECT_EQ(kernel.value(4.0), 0);
  EXPECT_EQ(kernel.value(5.0), 0);
}

TEST(WendlandC2, GradientFactorIsTheDerivativeOverDistance) {
  const auto kernel = WendlandC2<double>::make(0.9, 3);
  for (const double r : {0.1, 0.5, 0.9, 1.4, 1.79}) {
    const double d = 1e-6;
    const double slope = (kernel.value(r + d) - kernel.value(r - d)) / (2 * d);
    EXPECT_NEAR(kernel.gradient_factor(r) * r, slope, 1e-8);
  }
  EXPECT_EQ(kernel.gradient_factor(1.8), 0);
  EXPECT_EQ(kernel.gradient_factor(7.0), 0);
  EXPECT_LT(kernel.gradient_factor(0.0), 0);
}

}  // namespace
}  // namespace sabo
