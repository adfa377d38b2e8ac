#include "analysis/energy.hpp"

#include "cloud.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

const Tait water{1000, 50};

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

// 10 kg have gained 20 J: what a fall of 0.2 m gives at 10 m/s2.
TEST(SurplusFall, IsWhatAFlowCannotHave) {
  EXPECT_DOUBLE_EQ(surplus_fall({10, 0, 100, 0}, {8, 50, 40, 2}, {2, 8, 20, 0}, 10), 0.2);
  EXPECT_DOUBLE_EQ(surplus_fall({10, 0, 100, 0}, {10, 30, 60, 0}, {}, 10), -0.1);
  EXPECT_EQ(surplus_fall({}, {10, 30, 60, 0}, {}, 10), 0);
}

// 100 J at the start. 60 J of height are given up: 30 J of them are heat, 10 J the scheme took,
// 15 J are motion, 2 J went off with what left, whose height was worth 10 J. 3 J are missing.
TEST(EnergyBalance, FollowsWhatIsGivenUp) {
  const Energy start{10, 0, 100, 0};
  const Energy now{9, 14, 30, 1};
  const Energy left{1, 2, 10, 0};
  const EnergyBalance balance = energy_balance(start, now, left, 30, 10);
  EXPECT_DOUBLE_EQ(balance.released, 60);
  EXPECT_DOUBLE_EQ(balance.carried_off, 2);
  EXPECT_DOUBLE_EQ(balance.unaccounted, -3);
  EXPECT_DOUBLE_EQ(balance.imbalance(), -0.05);
  EXPECT_EQ(energy_balance(start, start, {}, 0, 0).imbalance(), 0);
}

}  // namespace
}  // namespace sabo
