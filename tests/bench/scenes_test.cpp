#include "bench/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "bench/step_clock.hpp"

namespace sabo {
namespace {

// At 0.015 m the tank has 107 x 45 x 27 cells: floor 108 x 46, ends 2 x 46 x 27, sides 2 x 106 x 27
// = 13176. The column is 8 cells wide (60 to 68, 16 to 24) and 30 high: 32 around, 29 levels above
// the floor and below the top, and the top 9 x 9. Water: 27 x 44 x 20.
TEST(DamBreak, HasTheParticlesOfTheExample) {
  const BenchFlow flow = dam_break(0.015, 1.5, 1);
  EXPECT_EQ(flow.backend->fluid().size(), 23760u);
  EXPECT_EQ(flow.backend->boundary().size(), 13176u + 32 * 29 + 81);
}

TEST(DamBreak, StaysTogetherForAWhile) {
  BenchFlow flow = dam_break(0.04, 1.7, 1);
  for (int step = 0; step < 60; ++step) flow.stepper->step();  // throws if a density runs away
  for (const Vec3d& x : flow.backend->fluid().position) {
    EXPECT_TRUE(x.x > 0 && x.x < 1.6 && x.y > 0 && x.y < 0.67 && x.z > 0 && x.z < 0.4);
  }
}

// 6 neighbours at 1, 12 at root 2, 8 at root 3, 6 at 2 spacings.
TEST(LatticeNeighbours, AreThoseWithinTheKernel) {
  EXPECT_EQ(lattice_neighbours(0.51), 6);
  EXPECT_EQ(lattice_neighbours(0.75), 18);
  EXPECT_EQ(lattice_neighbours(0.9), 26);
  EXPECT_EQ(lattice_neighbours(1.01), 32);
}

/// Heights by id.
std::map<std::uint32_t, double> heights(BenchFlow& flow) {
  std::map<std::uint32_t, double> result;
  for (std::size_t i = 0; i < flow.backend->fluid().size(); ++i)
    result[flow.backend->fluid().id[i]] = flow.backend->fluid().position[i].z;
  return result;
}

// Otherwise the comparison of dry terrain would compare two flows.
TEST(SlopeFlow, DoesTheSameOnALargerMap) {
  BenchFlow small = slope_flow(8, 3, 1);
  BenchFlow large = slope_flow(8, 9, 1);
  for (int step = 0; step < 30; ++step) {
    small.stepper->step();
    large.stepper->step();
  }
  EXPECT_GT(small.backend->boundary().size(), 300u);
  EXPECT_EQ(small.backend->boundary().size(), large.backend->boundary().size());
  const auto expected = heights(small);
  for (const auto& [id, height] : heights(large)) EXPECT_NEAR(height, expected.at(id), 1e-9);
}

TEST(StepClock, HoldsOneNeighbourListInEachRepetition) {
  BenchFlow flow = layer_flow(12, 1);
  const StepTimes times = step_times(flow, 3);
  ASSERT_EQ(times.seconds.values.size(), 3u);
  const auto pass = std::find_if(times.passes.begin(), times.passes.end(),
                                 [](const PassSamples& p) { return p.name == "neighbour search"; });
  ASSERT_NE(pass, times.passes.end());
  EXPECT_EQ(pass->seconds.values.size(), 3u);
  EXPECT_EQ(flow.backend->pass_times()["neighbour search"].calls, 1u);  // of the last
  // A step is 0.2 h / c0 and the flow runs at 0.05 c0: 0.01 h a step, of which 0.15 h fit.
  EXPECT_GT(times.steps_per_list(), 10);
  EXPECT_LT(times.steps_per_list(), 20);
}

TEST(StepClock, EndsARepetitionThatLastsTooLong) {
  BenchFlow flow = layer_flow(12, 1);
  std::size_t steps = 0;
  EXPECT_GT(repetition(flow, 4, steps), 0);
  EXPECT_EQ(steps, 4u);
}

}  // namespace
}  // namespace sabo
