// The exact solutions that cases compare with, against numbers from elsewhere.

#include "verify/elliptic_drop.hpp"
#include "verify/jet_pressure.hpp"
#include "verify/ordered_rows.hpp"
#include "verify/shear_flow.hpp"
#include "verify/sliding_dam_break.hpp"
#include "verify/slump_at_rest.hpp"
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

/// A Newtonian fluid between plates, u = a z (H - z) / (2 nu), of which the outermost rows know:
/// the others find it, for ordered rows carry the viscosity of the fluid.
TEST(OrderedRows, KeepTheParabola) {
  constexpr int cells = 20;
  const auto parabola = [](int k) {
    const double z = (k + 0.5) / cells;
    return z * (1 - z) / (2 * 0.1);
  };
  const OrderedRows rows{Newtonian{100}, 0, 1000, 1, 1, 1.5};
  std::vector<double> speeds(cells, 0.0);
  for (const int k : {0, 1, 2, 17, 18, 19}) speeds[k] = parabola(k);
  speeds = rows.after(8, speeds);
  for (int k = 0; k < cells; ++k) EXPECT_NEAR(speeds[k], parabola(k), 1e-3 * 1.25) << k;
}

/// Beside a yielded layer the outermost rows of a plug are too soft: the plug shears more than
/// tau / cap, by which from 0.005 to 0.095 m from the middle 10 (0.095^2 - 0.005^2) / 2 mm/s are
/// added up, and less so with more rows.
TEST(OrderedRows, SmoothTheEdgeOfAPlug) {
  const auto rise = [](int cells) {
    const ShearFlow exact(
        Bingham{{100, 1000}}, 0.5, [](double z) { return 1000 * (0.5 - z); },
        [](double) {
          return Shear{0, 125, 0};
        });
    std::vector<double> u(cells);
    for (int k = 0; k < cells; ++k) {
      const double z = (k + 0.5) / cells;
      u[k] = exact(std::min(z, 1 - z));
    }
    u = OrderedRows{Bingham{{100, 1000}}, 125, 1000, 1, 1, 1.5}.after(8, u);
    return u[cells / 2] - u[cells * 2 / 5];
  };
  const double coarse = rise(50), fine = rise(100);
  EXPECT_GT(coarse, 2 * fine);
  EXPECT_GT(fine, 4.5e-5);
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

/// A square column of 0.1 m: half lengths and heights in the middle computed by another program.
TEST(SlumpAtRest, HasTheLengthAndHeightOfItsVolume) {
  const struct {
    double b, length, height;
  } rows[] = {{0.005, 0.240, 0.0575}, {0.001, 0.458, 0.0319}};
  for (const auto& row : rows) {
    const SlumpAtRest slump{row.b};
    const double length = slump.length(0.01);
    EXPECT_NEAR(length, row.length, 5e-4);
    EXPECT_NEAR(slump.height(length), row.height, 5e-5);
    EXPECT_NEAR(slump.height(0), slump.front(), 1e-15);
    double volume = 0;
    for (int k = 0; k < 1000; ++k)
      volume += slump.height((k + 0.5) / 1000 * length) / 1000 * length;
    EXPECT_NEAR(volume, 0.01, 1e-8);
  }
}

TEST(SlidingDamBreak, RunsAheadOfRittersByWhatFrictionLeaves) {
  const double radian = 0.017453292519943295;
  const SlidingDamBreak slope{9.81, 30 * radian, 25 * radian, 0.5};
  EXPECT_NEAR(slope.place(0.1, 0), 0.41692341, 1e-8);  // 2 c0 t + m t^2 / 2, by another program
  EXPECT_NEAR(slope.place(1, 0), 2 * 2.06103 + 0.94339 / 2, 2e-5);
  const SlidingDamBreak ritter{9.81, 0, 0, 0.5};
  EXPECT_NEAR(ritter.place(3, 4.0 / 9 * 0.5), 0, 1e-12) << "the depth at the dam stays 4/9 h0";
  EXPECT_NEAR(ritter.place(3, 0.5), -3 * std::sqrt(9.81 * 0.5), 1e-12);
}

/// Axes and period computed by another program.
TEST(EllipticDrop, IsDrawnOutAndComesBack) {
  EllipticDrop drawn{100, 0};
  for (int k = 0; k < 76; ++k) drawn.advance(1e-4);
  EXPECT_NEAR(drawn.a, 1.9445, 5e-5);
  EXPECT_NEAR(drawn.b, 0.5143, 5e-5);
  EllipticDrop swinging{0.5, 1};
  EXPECT_NEAR(swinging.pressure(), 0.625, 1e-15);  // (0.25 + 1) / 2
  for (int k = 0; k < 1000; ++k) swinging.advance(4.567374e-3);
  EXPECT_NEAR(swinging.sigma, 0.5, 1e-6);
  EXPECT_NEAR(swinging.a, 1, 1e-6);
  EXPECT_NEAR(swinging.a * swinging.b, 1, 1e-9);
}

TEST(JetPressure, AddsUpToTheMomentumOfTheJet) {
  EXPECT_NEAR(jet_pressure(0), 1, 1e-12);
  EXPECT_NEAR(jet_pressure(0.644867), 0.75, 1e-6);  // q = 1/2: 2/pi (artanh 1/2 + arctan 1/2)
  double sum = 0;
  for (double x = 0.005; x < 8; x += 0.01) sum += 2 * 0.01 * jet_pressure(x);
  EXPECT_NEAR(sum, 2, 1e-4);
}

}  // namespace
}  // namespace sabo
