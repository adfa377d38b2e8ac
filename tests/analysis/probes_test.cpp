#include "analysis/probes.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

constexpr double dp = 0.1, rho = 1000, g = 9.81;
const auto kernel = WendlandC2<double>::make(1.5 * dp, 3);

/// Water on lattice cells [0, 12) x [0, 12) x [z0, z1), p = 300 + rho g (1 - z).
void add_water(Particles& water, int z0, int z1) {
  for (int k = z0; k < z1; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) {
        water.resize(water.size() + 1);
        water.position.back() = {(i + 0.5) * dp, (j + 0.5) * dp, (k + 0.5) * dp};
        water.mass.back() = rho * dp * dp * dp;
        water.density.back() = rho;
        water.pressure.back() = 300 + rho * g * (1 - water.position.back().z);
      }
}

TEST(Probe, ReadsTheHydrostaticPressureAlsoOnAWall) {
  Particles water;
  add_water(water, 0, 10);
  const Vec3d gravity{0, 0, -g};
  for (const Vec3d& point : {Vec3d{0.6, 0.6, 0.53}, {0, 0.6, 0.31}, {0.6, 0.6, 0}, {0, 0, 0}})
    EXPECT_NEAR(pressure_at(water, point, kernel, gravity), 300 + rho * g * (1 - point.z), 1e-9);
}

TEST(Probe, ReadsNothingWhereItIsDry) {
  Particles water;
  EXPECT_EQ(pressure_at(water, {}, kernel, {}), 0);
  add_water(water, 0, 3);
  EXPECT_EQ(pressure_at(water, {-0.3, 0.6, 0.1}, kernel, {}), 0);
}

// The lattice leaves sum V W = 1/2 where its cells end, to a hundredth of a spacing.
TEST(WaterHeight, IsThatOfTheFreeSurface) {
  Particles water;
  add_water(water, 0, 10);
  EXPECT_NEAR(water_height(water, {0.6, 0.6, 0}, kernel), 1, 0.01 * dp);
  EXPECT_NEAR(water_height(water, {0.63, 0.58, 0}, kernel), 1, 0.01 * dp);
  EXPECT_NEAR(water_height(water, {0.6, 0.6, 0.7}, kernel), 0.3, 0.01 * dp);
  EXPECT_EQ(water_height(water, {-0.3, 0.6, 0}, kernel), 0);
  EXPECT_EQ(water_height({}, {0, 0, 0}, kernel), 0);
}

TEST(WaterHeight, SeesAThinLayerOnTheFloor) {
  for (const int layers : {1, 2, 3}) {
    Particles water;
    add_water(water, 0, layers);
    EXPECT_NEAR(water_height(water, {0.6, 0.6, 0}, kernel), layers * dp, 0.1 * dp) << layers;
  }
}

TEST(WaterHeight, LeavesAirOut) {
  Particles water;
  add_water(water, 0, 4);
  add_water(water, 9, 13);
  EXPECT_NEAR(water_height(water, {0.6, 0.6, 0}, kernel), 0.8, 0.02 * dp);
}

}  // namespace
}  // namespace sabo
