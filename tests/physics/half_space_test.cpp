#include "physics/half_space.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

constexpr double h = 0.9;

/// The share of the kernel beyond a plane at the distance d, in three dimensions: the integral of
/// int W 2 pi r (r - d) dr with t = 1 - d/2h.
double closed_form(double d) {
  const double t = 1 - d / (2 * h);
  return std::pow(t, 6) * (7 - 9 * t + 3 * t * t) / 2;
}

// Straight lines between 129 places: off by at most max |S''| (2h/128)^2 / 8, and |S''| is at most
// 3.4 / (2h)^2: 2.6e-5.
TEST(HalfSpace, HasTheShareOfTheClosedForm) {
  const HalfSpace wall(h, 3, 0.6);
  for (double d = 0; d < 2 * h; d += 0.013) EXPECT_NEAR(wall.share(d), closed_form(d), 4e-5) << d;
  EXPECT_NEAR(wall.share(h), 0.5 / 64 * (7 - 4.5 + 0.75), 4e-5);
  EXPECT_EQ(wall.share(2 * h), 0);
  EXPECT_EQ(wall.share(9 * h), 0);
}

// In two dimensions there is no short form: the kernel summed over the cells beyond the plane.
TEST(HalfSpace, HasTheShareOfTheSumInTwoDimensions) {
  const HalfSpace wall(h, 2, 0.6);
  const auto kernel = WendlandC2<double>::make(h, 2);
  constexpr double cell = 0.01 * h;
  for (const double d : {0.0, 0.25 * h, 0.5 * h, h, 1.5 * h}) {
    double sum = 0;
    for (int i = -200; i < 200; ++i)
      for (double z = d + 0.5 * cell; z < 2 * h; z += cell)
        sum += kernel.value(std::hypot((i + 0.5) * cell, z)) * cell * cell;
    EXPECT_NEAR(wall.share(d), sum, 1e-4) << d;
  }
}

// Where the layers of the wall are fine the distance is the inverse of the closed form.
TEST(HalfSpace, TellsTheDistanceFromTheShareOfAFullWall) {
  const HalfSpace wall(h, 3, 0.01 * h);
  for (double d = 0.1 * h; d < 1.6 * h; d += 0.017)
    EXPECT_NEAR(wall.distance(closed_form(d)), d, 2e-3 * h) << d;
  EXPECT_EQ(wall.distance(0.51), 0);
  EXPECT_EQ(wall.distance(0.7), 0);  // within the wall
  EXPECT_EQ(wall.distance(0), 2 * h);
}

/// The share of a wall of particles, spacing 1, its surface half a spacing above the first layer.
double share_of_layers(int dimension, double smoothing, double d) {
  const auto kernel = WendlandC2<double>::make(smoothing, dimension);
  double share = 0;
  for (int z = 0; z < 8; ++z)
    for (int y = dimension == 3 ? -6 : 0; y <= (dimension == 3 ? 6 : 0); ++y)
      for (int x = -6; x <= 6; ++x)
        share += kernel.value(std::sqrt(x * x + y * y + (d + 0.5 + z) * (d + 0.5 + z)));
  return share;
}

// A particle of a lattice that goes on from the wall is half a spacing from its surface; by the
// share of a full wall it would be 7 % farther away, and friction as much too small.
TEST(HalfSpace, TellsTheDistanceToAWallOfParticles) {
  for (const int dimension : {2, 3})
    for (const double smoothing : {1.5, 2.0}) {
      const HalfSpace wall(smoothing, dimension, 1);
      EXPECT_NEAR(wall.distance(share_of_layers(dimension, smoothing, 0.5)), 0.5, 0.01);
      EXPECT_NEAR(wall.distance(share_of_layers(dimension, smoothing, 1.5)), 1.5, 0.03);
      const HalfSpace full(smoothing, dimension, 0.01);
      EXPECT_GT(full.distance(share_of_layers(dimension, smoothing, 0.5)), 0.515);
    }
}

/// Sums over a lattice of the spacing 1 that ends at a plane surface, for its k-th layer from it.
struct LayerSums {
  double share = 0;     ///< sum of V W
  double gradient = 0;  ///< of it, towards the inside
};
LayerSums layer_below_surface(int dimension, double smoothing, int k) {
  const auto kernel = WendlandC2<double>::make(smoothing, dimension);
  const int reach = static_cast<int>(2 * smoothing) + 1;
  LayerSums sums;
  for (int z = -reach; z <= k; ++z)
    for (int y = dimension == 3 ? -reach : 0; y <= (dimension == 3 ? reach : 0); ++y)
      for (int x = -reach; x <= reach; ++x) {
        const double r = std::sqrt(double(x * x + y * y + z * z));
        sums.share += kernel.value(r);
        sums.gradient += kernel.gradient_factor(r) * z;  // the surface is up, the inside below
      }
  return sums;
}

// Sums over a lattice know the place of a surface half a spacing away to a few hundredths of a
// spacing, the worse the fewer neighbours; a spacing is up to a third of the kernel radius.
TEST(HalfSpace, CompletesALatticeAtEveryDepthBelowItsSurface) {
  for (const int dimension : {2, 3})
    for (const double smoothing : {1.2, 1.5, 2.0}) {
      const HalfSpace space(smoothing, dimension, 1);
      for (int k = 0; k < 6; ++k) {
        const LayerSums sums = layer_below_surface(dimension, smoothing, k);
        const double tolerance = smoothing < 1.5 ? 0.06 : 0.04;
        EXPECT_NEAR(sums.share * space.completion(sums.gradient / sums.share), 1, tolerance)
            << dimension << "D, h/dp " << smoothing << ", layer " << k;
      }
      EXPECT_EQ(space.completion(0), 1);
      EXPECT_NEAR(space.completion(1e9), 2, 1e-3);
    }
}

// Without the completion the first layer would look 20 to 30 % too empty.
TEST(HalfSpace, TheFirstLayerNeedsItsCompletion) {
  const LayerSums sums = layer_below_surface(3, 1.5, 0);
  EXPECT_LT(sums.share, 0.85);
  EXPECT_GT(sums.share, 0.6);
}

// Twice the particles in the same places: share and gradient double, so the factor stays.
TEST(HalfSpace, CompletionKeepsTheDegreeOfCrowding) {
  const HalfSpace space(1.5, 3, 1);
  const LayerSums one = layer_below_surface(3, 1.5, 0);
  const double crowded =
      1.25 * one.share * space.completion(1.25 * one.gradient / (1.25 * one.share));
  EXPECT_NEAR(crowded, 1.25 * one.share * space.completion(one.gradient / one.share), 1e-12);
}

}  // namespace
}  // namespace sabo
