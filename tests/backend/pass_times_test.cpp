#include "backend/pass_times.hpp"

#include <thread>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.hpp"

namespace sabo {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

TEST(PassTimes, SumCallsTimeAndPairsByName) {
  PassTimes times;
  for (int call = 0; call < 3; ++call) {
    const PassClock clock(times, "a", 7);
    std::this_thread::sleep_for(milliseconds(2));
  }
  { const PassClock clock(times, "b"); }
  ASSERT_EQ(times.passes().size(), 2u);
  const PassTime a = times["a"];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.calls, 3u);
  EXPECT_EQ(a.pairs, 21u);
  EXPECT_GE(a.seconds, 0.006);
  EXPECT_EQ(times["b"].calls, 1u);
  EXPECT_EQ(times["b"].pairs, 0u);
  EXPECT_EQ(times.seconds(), a.seconds + times["b"].seconds);
}

// Spacing 1, h = 1.5, list radius 2.3 h = 3.45: in a row of particles along x each lists three to
// either side. Five of fluid, then two of boundary, which list fluid only.
TEST(PassTimes, CountTheListedPairsWithoutPadding) {
  const FlowModel model = test::plain_model(1, 10, 1);
  CpuBackend backend(model);
  for (int i = 0; i < 5; ++i) test::add_particle(backend.fluid(), model, {1.0 * i, 0, 0});
  for (int i = 5; i < 7; ++i) test::add_particle(backend.boundary(), model, {1.0 * i, 0, 0});
  backend.find_neighbours();
  backend.pressure();
  backend.strain_and_density_rates();
  backend.stress();
  backend.momentum();
  // Fluid 0 to 4: 3, 4, 5 (to 5), 6 (to 6), 5 (1-3, 5, 6); boundary 5 and 6: 2-4 and 3-4.
  EXPECT_EQ(backend.pass_times()["force sweep"].pairs, 3u + 4 + 5 + 6 + 5);
  EXPECT_EQ(backend.pass_times()["motion sweep"].pairs, 23u + 3 + 2);
  EXPECT_EQ(backend.pass_times()["neighbour search"].pairs, 28u);
}

TEST(PassTimes, DoNotOverlapAndCoverTheSteps) {
  test::Layer layer;
  layer.model = test::plain_model(0.1, 30, 1);
  layer.period = 16;
  const auto backend = layer.make();
  PaperStepper stepper(*backend, test::rule_of(layer.model), nullptr);
  backend->pass_times().clear();
  const auto start = steady_clock::now();
  for (int k = 0; k < 5; ++k) stepper.step();
  const double wall = duration<double>(steady_clock::now() - start).count();
  EXPECT_LE(backend->pass_times().seconds(), wall);
  EXPECT_GE(backend->pass_times().seconds(), 0.6 * wall);      // the rest is noise of the machine
  EXPECT_EQ(backend->pass_times()["force sweep"].calls, 10u);  // two evaluations a step
}

}  // namespace
}  // namespace sabo
