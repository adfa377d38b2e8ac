#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "physics/equation_of_state.hpp"
#include "physics/time_step.hpp"
#include "physics/yield.hpp"

namespace sabo {
namespace {

TEST(Tait, SlopeAtTheReferenceIsTheSquareOfTheSoundSpeed) {
  const Tait state{1726, 60.7};
  const double d = 1e-3;
  const double slope = (state.pressure(1726 + d) - state.pressure(1726 - d)) / (2 * d);
  EXPECT_NEAR(slope, 60.7 * 60.7, 1e-3);
  EXPECT_EQ(state.pressure(1726), 0);
}

TEST(Tait, MatchesThePowerFarFromTheReference) {
  const Tait state{1000, 10};  // B = 1e5 / 7
  EXPECT_NEAR(state.pressure(1100), 1e5 / 7 * (std::pow(1.1, 7) - 1), 1e-8);
  EXPECT_NEAR(state.pressure(900), 1e5 / 7 * (std::pow(0.9, 7) - 1), 1e-8);
}

TEST(Tait, SoundSpeedIsTheRootOfTheSlope) {
  const Tait state{1000, 10};
  EXPECT_DOUBLE_EQ(state.sound_speed(1000), 10);
  const double d = 1e-3;
  const double slope = (state.pressure(1100 + d) - state.pressure(1100 - d)) / (2 * d);
  EXPECT_NEAR(state.sound_speed(1100), std::sqrt(slope), 1e-6);  // 10 x 1.1^3
}

TEST(Tait, DensityInvertsPressure) {
  const Tait state{1726, 100};
  for (const double p : {-1e4, 0.0, 1.0, 6.3e4, 1e6})
    EXPECT_NEAR(state.pressure(state.density(p)), p, 1e-9 * state.b());
}

const Tait water{1000, 50};

TEST(ElasticEnergy, VanishesAtTheReferenceDensityOnly) {
  EXPECT_EQ(water.elastic_energy(1000), 0);
  EXPECT_GT(water.elastic_energy(1001), 0);
  EXPECT_GT(water.elastic_energy(999), 0);
}

// x = 2: c0^2/7 ((64 - 1)/6 + 1/2 - 1) = 2500/7 x 10.
TEST(ElasticEnergy, OfDoubledDensity) {
  EXPECT_NEAR(water.elastic_energy(2000), 25000. / 7, 1e-10);
}

TEST(ElasticEnergy, OfSmallStrainIsThatOfASpring) {
  // c0^2 e^2 / 2 (1 + 4/3 e + ...): the next term is below 2e-8 of it.
  EXPECT_NEAR(water.elastic_energy(1000 + 1e-5) / (1250 * 1e-16), 1, 1e-6);
}

TEST(ElasticEnergy, DerivativeIsPressureOverDensitySquared) {
  EXPECT_TRUE(rc::check("de/drho = p / rho^2", [] {
    const double rho = 800 + *rc::gen::inRange(0, 4000) / 10.0;
    const double step = 1e-3;
    const double slope =
        (water.elastic_energy(rho + step) - water.elastic_energy(rho - step)) / (2 * step);
    const double expected = water.pressure(rho) / (rho * rho);
    // Rounding of the difference: 1e-16 of e (at most 60 J/kg) over the step.
    RC_ASSERT(std::abs(slope - expected) < 1e-10);
  }));
}

TEST(MohrCoulomb, AddsFrictionOfTheEffectivePressureToCohesion) {
  const MohrCoulomb dry{50, 30, 0};
  EXPECT_NEAR(dry(1000, dry.slope()), 50 + 1000 / std::sqrt(3.0), 1e-10);
  const MohrCoulomb half{50, 30, 0.5};
  EXPECT_NEAR(half(1000, half.slope()), 50 + 500 / std::sqrt(3.0), 1e-10);
}

TEST(MohrCoulomb, SuctionAndLiquefactionLeaveCohesion) {
  const MohrCoulomb soil{50, 30, 0};
  EXPECT_EQ(soil(-1e5, soil.slope()), 50);
  const MohrCoulomb liquid{50, 30, 1};
  EXPECT_EQ(liquid(1e5, liquid.slope()), 50);
}

TEST(MohrCoulomb, PoreWaterTakesItsShareOfThePressure) {
  const MohrCoulomb soil{50, 30, 0.25};
  EXPECT_DOUBLE_EQ(soil.effective_pressure(1000), 750);
  EXPECT_EQ(soil.effective_pressure(-1000), 0);
}

TEST(TimeStepRule, TakesTheSmallestOfThreeLimits) {
  const TimeStepRule rule{2.0, 50.0, 0.2, 0.6};
  EXPECT_DOUBLE_EQ(rule({0, 0, 0}).dt, 0.2 * 2 / 50);
  EXPECT_DOUBLE_EQ(rule({8, 0, 0}).dt, 0.2 * 2 / 80);  // 10 v beats c0
  const TimeStep by_acceleration = rule({0, 20000, 0});
  EXPECT_EQ(by_acceleration.limit, StepLimit::acceleration);
  EXPECT_DOUBLE_EQ(by_acceleration.dt, 0.2 * 0.01);  // sqrt(2/20000)
  const TimeStep by_viscosity = rule({0, 0, 1000});
  EXPECT_EQ(by_viscosity.limit, StepLimit::viscous);
  EXPECT_DOUBLE_EQ(by_viscosity.dt, 0.6 * 4 / 1000);
  EXPECT_DOUBLE_EQ(rule.longest({0, 0, 1000}), 0.6 * 4 / 1000);
}

TEST(FastStepRule, TakesTheSmallerOfTwoLimits) {
  const FastStepRule rule{2.0, 0.2, 42.0};
  EXPECT_DOUBLE_EQ(rule.longest({0, 0, 0}), 0.2 * 2 / 42);
  EXPECT_DOUBLE_EQ(rule.longest({8, 0, 1e9}), 0.2 * 2 / 50);
  EXPECT_DOUBLE_EQ(rule.longest({8, 20000, 0}), 0.25 * 0.01);  // sqrt(2/20000)
}

}  // namespace
}  // namespace sabo
