#include "bench/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "bench/step_clock.hpp"

namespace sabo {
namespace {

// At 0.015 m the tank has 107 x 45 x 27 cells: floor 108 x 46, ends 2 x 46 x 27, sides 2 x 106 x 27
// = 13176. The column is 8 cells wide (60 to 68, 16 to 24) and 30 high: 32 around, 29 levels above
// the floor and below the top, and the top 9 x 9. Water: 27 x 44 x 20.
TEST(DamBreak, HasTheParticlesOfTheExample) {
  const BenchFlow flow = dam_break(Method::paper, 0.015, 1.5, 1);
  EXPECT_EQ(flow.backend->fluid().size(), 23760u);
  EXPECT_EQ(flow.backend->boundary().size(), 13176u + 32 * 29 + 81);
}

/// What holds for both methods.
class Methods : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Of, Methods, testing::Values(Method::fast, Method::paper),
                         [](const auto& method) { return std::string(word_of(method.param)); });

TEST_P(Methods, KeepADamBreakTogetherForAWhile) {
  BenchFlow flow = dam_break(GetParam(), 0.04, 1.7, 1);
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

// Otherwise the comparison of dry terrain would compare two flows. The map grows by whole tiles of
// ground on each side; every number in the way is a multiple of a power of two, so nothing rounds
// differently.
TEST_P(Methods, DoTheSameToTheLastBitOnALargerMap) {
  constexpr int side = 8;
  BenchFlow small = slope_flow(GetParam(), side, smallest_map_side(side), 1);
  BenchFlow large = slope_flow(GetParam(), side, 3 * smallest_map_side(side), 1);
  // Until the flow meets ground that was not there at the start.
  const std::size_t ground = small.backend->boundary().size();
  int steps = 0;
  for (; steps < 150 && small.backend->boundary().size() == ground; ++steps) {
    small.stepper->step();
    large.stepper->step();
  }
  ASSERT_GT(small.backend->boundary().size(), ground);
  for (const auto& [a, b] : {std::pair{&small.backend->fluid(), &large.backend->fluid()},
                             {&small.backend->boundary(), &large.backend->boundary()}}) {
    ASSERT_EQ(a->size(), b->size());
    for (std::size_t i = 0; i < a->size(); ++i) {
      ASSERT_EQ(a->id[i], b->id[i]);
      ASSERT_EQ(norm(a->position[i] - b->position[i]), 0) << "particle " << i;
    }
  }
}

TEST_P(Methods, HaveOneNeighbourListInEachRepetition) {
  BenchFlow flow = layer_flow(GetParam(), 12, 1);
  const StepTimes times = step_times(flow, 3);
  ASSERT_EQ(times.seconds.values.size(), 3u);
  const auto pass = std::find_if(times.passes.begin(), times.passes.end(),
                                 [](const PassSamples& p) { return p.name == "neighbour search"; });
  ASSERT_NE(pass, times.passes.end());
  EXPECT_EQ(pass->seconds.values.size(), 3u);
  EXPECT_EQ(flow.backend->pass_times()["neighbour search"].calls, 1u);  // of the last
  // The flow runs at 0.05 c0 over ground at rest, and a list lasts 0.3 h, but for half a step ahead
  // with method paper. paper: a step is 0.2 h / c0, 0.01 h; 30 of them. fast: 0.6 h / 1.05 c0,
  // 0.0286 h, and the step that goes beyond the list counts, for the next one begins with a new
  // one; 11 of them.
  const int expected = GetParam() == Method::paper ? 30 : 11;
  EXPECT_NEAR(times.steps_per_list(), expected, 1.5);
}

TEST(StepClock, EndsARepetitionThatLastsTooLong) {
  BenchFlow flow = layer_flow(Method::fast, 12, 1);
  std::size_t steps = 0;
  EXPECT_GT(repetition(flow, 4, steps), 0);
  EXPECT_EQ(steps, 4u);
}

}  // namespace
}  // namespace sabo
