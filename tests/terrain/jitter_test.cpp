#include "terrain/jitter.hpp"

#include <cmath>

#include "rasters.hpp"
#include <gtest/gtest.h>

#include "terrain/release.hpp"

namespace sabo {
namespace {

Surface long_slope() {
  return Surface(raster_of(square_grid(0, 40, 1), [](double x, double) { return 0.75 * x; }));
}

Particles block(const Surface& surface) {
  const Polygon square{{{{4, 4, 0}, {36, 4, 0}, {36, 36, 0}, {4, 36, 0}}}};
  return released(surface, release_of({{square, 2}}), {0.5, 1700, {}});
}

// 64 x 64 columns of 4: the mean of so many even numbers in [-reach, reach) has a standard
// deviation of reach / sqrt(3 x 16384) = 0.0045 reach, their spread is reach / sqrt(3).
TEST(Jitter, IsEvenWithinItsReachOnEachAxis) {
  const Surface surface = long_slope();
  const Particles before = block(surface);
  Particles after = before;
  constexpr double reach = 0.15;
  jitter(after, surface, {reach, 0.1, 7});
  ASSERT_EQ(after.size(), 16384U);
  Vec3d mean, square;
  for (std::size_t i = 0; i < after.size(); ++i) {
    Vec3d shift = after.position[i] - before.position[i];
    shift.z -= 0.75 * shift.x;  // it follows the ground
    for (const double part : {shift.x, shift.y, shift.z}) ASSERT_LE(std::abs(part), reach + 1e-12);
    mean += (1. / 16384) * shift;
    square += (1. / 16384) * Vec3d{shift.x * shift.x, shift.y * shift.y, shift.z * shift.z};
  }
  for (const double part : {mean.x, mean.y, mean.z}) EXPECT_LT(std::abs(part), 0.02 * reach);
  for (const double part : {square.x, square.y, square.z})
    EXPECT_NEAR(part, reach * reach / 3, 0.02 * reach * reach / 3 * 1.5);
}

TEST(Jitter, LeavesMassesAndHydrostaticDensitiesAlone) {
  const Surface surface = long_slope();
  const Particles before = block(surface);
  Particles after = before;
  jitter(after, surface, {0.15, 0.1, 1});
  EXPECT_EQ(after.mass, before.mass);
  EXPECT_EQ(after.density, before.density);
}

TEST(Jitter, KeepsAllAboveTheGround) {
  // A roof that falls off on both sides, and particles 1 cm above the ground among the rest.
  const Surface surface(
      raster_of(square_grid(0, 40, 1), [](double x, double) { return -2 * std::abs(x - 20); }));
  Particles particles = block(surface);
  for (std::size_t i = 0; i < particles.size(); i += 5) {
    Vec3d& x = particles.position[i];
    x.z = surface.height(x.x, x.y) + 0.01;
  }
  jitter(particles, surface, {0.15, 0.1, 3});
  for (const Vec3d& x : particles.position) ASSERT_GE(x.z - surface.height(x.x, x.y), 0.01 - 1e-12);
}

TEST(Jitter, DependsOnSeedAndNumberAlone) {
  const Surface surface = long_slope();
  Particles one = block(surface), again = one, other = one, turned = one;
  std::vector<std::uint32_t> order(one.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = static_cast<std::uint32_t>(order.size() - 1 - k);
  turned.permute(order);
  jitter(one, surface, {0.1, 0.1, 1});
  jitter(again, surface, {0.1, 0.1, 1});
  jitter(other, surface, {0.1, 0.1, 2});
  jitter(turned, surface, {0.1, 0.1, 1});
  turned.permute(order);
  EXPECT_EQ(one.position, again.position);
  EXPECT_EQ(one.position, turned.position);
  std::size_t same = 0;
  for (std::size_t i = 0; i < one.size(); ++i) same += one.position[i] == other.position[i];
  EXPECT_EQ(same, 0U);
}

TEST(Jitter, OfNoReachChangesNothing) {
  const Surface surface = long_slope();
  const Particles before = block(surface);
  Particles after = before;
  jitter(after, surface, {0, 0.1, 1});
  EXPECT_EQ(after.position, before.position);
}

TEST(Jitter, StaysOnTheSurface) {
  const Surface surface = long_slope();
  Particles edge;
  edge.resize(100);
  for (std::uint32_t k = 0; k < 100; ++k) {
    edge.id[k] = k;
    edge.position[k] = {0, 20, surface.height(0, 20) + 1};  // the last cell centre
  }
  jitter(edge, surface, {0.9, 0.1, 1});
  for (const Vec3d& x : edge.position) {
    EXPECT_TRUE(surface.inside(x.x, x.y));
    EXPECT_TRUE(std::isfinite(x.z));
  }
}

}  // namespace
}  // namespace sabo
