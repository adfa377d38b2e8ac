#include "analysis/energy.hpp"

#include <cmath>

#include "cloud.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace sabo {
namespace {

const Tait water{1000, 50};

TEST(ElasticEnergy, vanishes_at_the_reference_density_only) {
  EXPECT_EQ(elastic_energy(water, 1000), 0);
  EXPECT_GT(elastic_energy(water, 1001), 0);
  EXPECT_GT(elastic_energy(water, 999), 0);
}

// x = 2: c0^2/7 ((64 - 1)/6 + 1/2 - 1) = 2500/7 x 10.
TEST(ElasticEnergy, of_doubled_density) {
  EXPECT_NEAR(elastic_energy(water, 2000), 25000. / 7, 1e-10);
}

TEST(ElasticEnergy, of_small_strain_is_that_of_a_spring) {
  // c0^2 e^2 / 2 (1 + 4/3 e + ...): the next term is below 2e-8 of it.
  EXPECT_NEAR(elastic_energy(water, 1000 + 1e-5) / (1250 * 1e-16), 1, 1e-6);
}

TEST(ElasticEnergy, derivative_is_pressure_over_density_squared) {
  EXPECT_TRUE(rc::check("de/drho = p / rho^2", [] {
    const double rho = 800 + *rc::gen::inRange(0, 4000) / 10.0;
    const double step = 1e-3;
    const double slope =
        (elastic_energy(water, rho + step) - elastic_energy(water, rho - step)) / (2 * step);
    const double expected = water.pressure(rho) / (rho * rho);
    // Rounding of the difference: 1e-16 of e (at most 60 J/kg) over the step.
    RC_ASSERT(std::abs(slope - expected) < 1e-10);
  }));
}

TEST(Energy, of_two_particles) {
  Particles particles = cloud({{0, 0, 10}, {5, 0, -1}}, 2);
  particles.velocity = {{3, 0, 4}, {0, 0, 0}};
  particles.density = {1000, 2000};
  const Energy energy = energy_of(particles, {0, 0, -10}, water);
  EXPECT_EQ(energy.mass, 4);
  EXPECT_EQ(energy.kinetic, 25);
  EXPECT_EQ(energy.potential, 180);  // 2 x 10 x 10 - 2 x 10 x 1
  EXPECT_NEAR(energy.elastic, 50000. / 7, 1e-9);
  EXPECT_DOUBLE_EQ(energy.total(), 205 + energy.elastic);
}

TEST(Energy, sums_over_all_blocks) {
  Particles many = cloud(std::vector<Vec3d>(5000, {0, 0, 1}), 3);
  for (double& density : many.density) density = 1000;
  const Energy energy = energy_of(many, {0, 0, -1}, water);
  EXPECT_EQ(energy.mass, 15000);
  EXPECT_EQ(energy.potential, 15000);
  EXPECT_EQ(energy_of(Particles{}, {0, 0, -1}, water).mass, 0);
}

// 100 J at the start. 60 J of height are given up: 40 J of them are heat, 15 J motion, 2 J went off
// with what left, whose height was worth 10 J. 3 J are missing.
TEST(EnergyBalance, FollowsWhatIsGivenUp) {
  const Energy start{10, 0, 100, 0};
  const Energy now{9, 14, 30, 1};
  const Energy left{1, 2, 10, 0};
  const EnergyBalance balance = energy_balance(start, now, left, 40);
  EXPECT_DOUBLE_EQ(balance.released, 60);
  EXPECT_DOUBLE_EQ(balance.carried_off, 2);
  EXPECT_DOUBLE_EQ(balance.unaccounted, -3);
  EXPECT_DOUBLE_EQ(balance.imbalance(), -0.05);
  EXPECT_EQ(energy_balance(start, start, {}, 0).imbalance(), 0);
}

}  // namespace
}  // namespace sabo
