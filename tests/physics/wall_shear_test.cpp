#include "physics/wall_shear.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "math/angle.hpp"

namespace sabo {
namespace {

// 10 kPa on the wall at 5 m/s; sticking to it would take 50 kPa.
constexpr WallContact sliding{5, 1e4, 2000, 10, 1e4};

TEST(NoSlip, IsTheStressOfTheFluidItself) {
  EXPECT_EQ(NoSlip{}.resistance(sliding), 1e4);
  EXPECT_EQ(Slip{}.resistance(sliding), 0);
}

// 100 Pa + 0.2 x 10 kPa = 2100 Pa at any speed, as long as sticking would take more.
TEST(Coulomb, HoldsASlidingFlowBackByItsStressAlone) {
  const Coulomb law{100, 0.2};
  EXPECT_DOUBLE_EQ(law.resistance(sliding), 2100 / 5.0);
  WallContact faster = sliding;
  faster.speed = 50;
  EXPECT_DOUBLE_EQ(law.resistance(faster) * faster.speed, 2100);
  WallContact lifted = sliding;
  lifted.pressure = 0;
  EXPECT_DOUBLE_EQ(law.resistance(lifted) * lifted.speed, 100);
}

TEST(Coulomb, LetsASlowFlowStick) {
  const Coulomb law{100, 0.2};
  WallContact slow = sliding;
  slow.speed = 0.2;  // sticking takes 2000 Pa there
  EXPECT_EQ(law.resistance(slow), 1e4);
  slow.speed = 0;
  EXPECT_EQ(law.resistance(slow), 1e4);
}

// 2100 Pa and 2000 x 10 x 25 / 500 = 1000 Pa of turbulence.
TEST(Voellmy, AddsTheSquareOfTheSpeed) {
  const Voellmy law{{100, 0.2}, 500};
  EXPECT_DOUBLE_EQ(law.resistance(sliding) * 5, 3100);
  WallContact faster = sliding;
  faster.speed = 10;
  EXPECT_DOUBLE_EQ(law.resistance(faster) * 10, 2100 + 4000);
}

// Depth 2 m on a slope of 20 deg, tan(delta) 0.2, xi 500: gravity along the slope and the wall
// balance at v^2 = xi h (sin - cos tan(delta)): 12.4 m/s (Voellmy 1955).
TEST(Voellmy, HasItsTerminalSpeed) {
  const double slope = 20 * degree, depth = 2;
  const double v = std::sqrt(500 * depth * (std::sin(slope) - 0.2 * std::cos(slope)));
  EXPECT_NEAR(v, 12.4, 0.05);
  const WallContact at{v, 2000 * 9.81 * depth * std::cos(slope), 2000, 9.81, 1e9};
  EXPECT_NEAR((Voellmy{{0, 0.2}, 500}.resistance(at) * v), 2000 * 9.81 * depth * std::sin(slope),
              1e-6);
}

// For any flow and any wall: no law pushes, none holds more than sticking, and a faster flow is
// never held by less stress.
TEST(WallShear, NeverPushesAndNeverHoldsMoreThanSticking) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-4, 5), u(0, 1);
  const auto any = [&] { return u(random) < 0.1 ? 0 : std::pow(10, exponent(random)); };
  for (int trial = 0; trial < 20000; ++trial) {
    const WallContact slower{any(), any(), 500 + 2000 * u(random), 20 * u(random), any()};
    WallContact faster = slower;
    faster.speed *= 1 + u(random);
    const Coulomb friction{any(), 2 * u(random)};
    for (const WallShear& wall : {WallShear{NoSlip{}}, WallShear{friction},
                                  WallShear{Voellmy{friction, 1 + any()}}, WallShear{Slip{}}}) {
      const auto resistance = [&](const WallContact& at) {
        return std::visit([&](const auto& law) { return law.resistance(at); }, wall);
      };
      const double r = resistance(slower);
      ASSERT_GE(r, 0);
      ASSERT_LE(r, slower.sticking);
      ASSERT_GE(resistance(faster) * faster.speed, r * slower.speed * (1 - 1e-12));
    }
  }
}

}  // namespace
}  // namespace sabo
