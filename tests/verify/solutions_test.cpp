// The exact solutions that cases compare with, against numbers from elsewhere.

#include "verify/shear_flow.hpp"
#include "verify/startup_solution.hpp"
#include <gtest/gtest.h>

#include "physics/yield.hpp"

namespace sabo {
namespace {

TEST(StartUp, HasTheValuesInTheMiddle) {
  // Summed by another program to 1e-4 of the greatest speed.
  const struct {
    double t, poiseuille, couette;
  } rows[] = {{0.0225, 0.1786, 0.0184},
              {0.045, 0.3388, 0.0956},
              {0.1125, 0.6600, 0.2903},
              {0.225, 0.8880, 0.4309},
              {1, 0.9999, 0.5}};
  const StartUp flow;
  for (const auto& row : rows) {
    EXPECT_NEAR(flow.poiseuille(0.5e-3, row.t) / 1.25e-5, row.poiseuille, 1e-4);
    EXPECT_NEAR(flow.couette(0.5e-3, row.t) / 1.25e-5, row.couette, 1e-4);
  }
  EXPECT_NEAR(flow.poiseuille(0, 0.0225), 0, 1e-12);
  EXPECT_NEAR(flow.couette(1e-3, 0.0225), 1.25e-5, 1e-12);
}

TEST(RateAtStress, InvertsTheLaw) {
  EXPECT_NEAR(rate_at_stress(Newtonian{5}, 20, {}), 4, 1e-9);
  // Exact Bingham, mu_B 100, tau_B 125: (325 - 125) / 100; below yield tau / cap.
  EXPECT_NEAR(rate_at_stress(Bingham{{100, 1000}}, 325, {0, 125, 0}), 2, 1e-9);
  EXPECT_NEAR(rate_at_stress(Bingham{{100, 1000}}, 50, {0, 125, 0}), 5e-4, 1e-12);
  EXPECT_EQ(rate_at_stress(Newtonian{5}, 0, {}), 0);
}

/// Half a slit 1 m high, driven by 1000 Pa/m: plug speeds computed by another program.
TEST(ShearFlow, HasThePlugSpeedsOfTheSlit) {
  const auto speed = [](const Rheology& law) {
    return ShearFlow(
               law, 0.5, [](double z) { return 1000 * (0.5 - z); },
               [](double) {
                 return Shear{0, 125, 0};
               })
        .top();
  };
  EXPECT_NEAR(speed(Cross{100, 1e3, 1}), 0.704844, 2e-6);
  EXPECT_NEAR(speed(Cross{100, 1e5, 1}), 0.703149, 2e-6);
  EXPECT_NEAR(speed(HerschelBulkley{100, 0.5, 1e6, 1e9}), 1.757813, 2e-5);
}

/// theta 30, phi 20 degrees, mu_0/mu_B 1000, H 0.1 m: surface speeds computed by another program.
TEST(ShearFlow, HasTheSurfaceSpeedsOfTheIncline) {
  const double theta = 0.5235987756, across = 1600 * 9.81 * std::cos(theta);
  for (const auto& [cohesion, speed] : {std::pair{0.0, 2.9138}, std::pair{50.0, 2.0132}}) {
    const MohrCoulomb yield{cohesion, 20, 0};
    const ShearFlow flow(
        Cross{5, 1000, 1}, 0.1, [&](double z) { return 1600 * 9.81 * std::sin(theta) * (0.1 - z); },
        [&](double z) {
          return Shear{0, yield(across * (0.1 - z), yield.slope()), 0};
        });
    EXPECT_NEAR(flow.top(), speed, 1e-4);
    EXPECT_EQ(flow(-1), 0);
    EXPECT_EQ(flow(1), flow.top());
  }
}

}  // namespace
}  // namespace sabo
