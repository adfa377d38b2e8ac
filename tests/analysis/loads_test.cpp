#include <cmath>

#include <gtest/gtest.h>

#include "analysis/approach.hpp"
#include "analysis/load_peak.hpp"
#include "analysis/load_profile.hpp"

namespace sabo {
namespace {

TEST(LoadPeak, IsTheGreatestMeanOverItsWindow) {
  LoadPeak peak(0.2);
  // 10 N for one second, a blow of 100 N over 0.05 s, then 10 N again; steps of 0.05 s.
  Vec3d impulse;
  double time = 0;
  for (int k = 0; k < 40; ++k) {
    time += 0.05;
    impulse.x += (k == 20 ? 100 : 10) * 0.05;
    peak.add(time, impulse);
  }
  EXPECT_NEAR(peak.force(), (100 * 0.05 + 10 * 0.15) / 0.2, 1e-9);  // 32.5
  EXPECT_GE(peak.time(), 1.05 - 1e-9);
  EXPECT_LE(peak.time(), 1.2 + 1e-9);
}

TEST(LoadPeak, CutsAStepThatIsLongerThanItsWindow) {
  LoadPeak peak(0.1);
  peak.add(1, {0, 0, 0});
  peak.add(2, {3, 4, 50});  // 5 N horizontally all that second; the vertical part does not count
  EXPECT_NEAR(peak.force(), 5, 1e-12);
  EXPECT_EQ(peak.time(), 2);
}

TEST(LoadPeak, CountsNothingBeforeTheStart) {
  LoadPeak peak(1);
  peak.add(0.5, {8, 0, 0});
  EXPECT_NEAR(peak.force(), 8, 1e-12);  // 16 N over half of the window
}

// All of the first step's impulse counts, whenever that is.
TEST(LoadPeak, MayStartLate) {
  LoadPeak peak(0.1, 60);
  peak.add(60.01, {2, 0, 0});
  EXPECT_NEAR(peak.force(), 20, 1e-12);
  peak.add(60.02, {3, 0, 0});
  EXPECT_NEAR(peak.force(), 30, 1e-12);
}

TEST(LoadProfile, SharesTheForceOutByHeight) {
  LoadProfile profile(10, 0.5, 1.2);
  // Two seconds: 6 N in the lowest bin, 2 N in the third; places 0.5 m apart across the force.
  for (const double y : {0.25, 0.75, 1.25}) {
    profile.add({0, y, 10.2}, {4, 0, 1});
    profile.see({0, y, 10.2}, true);
  }
  profile.add({0, 3, 11.1}, {4, 0, 0});
  profile.see({0, 3, 11.1}, true);
  profile.see({0.1, 3, 11.2}, true);   // behind the other one: no wider
  profile.see({0.5, 3, 11.1}, false);  // deeper: out of reach, no less wide
  const auto bins = profile.take(2);
  ASSERT_EQ(bins.size(), 3u);
  EXPECT_EQ(bins[0].bottom, 10);
  EXPECT_EQ(bins[0].top, 10.5);
  EXPECT_NEAR(bins[0].force.x, 6, 1e-12);
  EXPECT_NEAR(bins[0].width, 1.5, 1e-12);
  EXPECT_NEAR(bins[0].pressure(), 6 / (1.5 * 0.5), 1e-12);
  EXPECT_EQ(bins[1].width, 0);
  EXPECT_EQ(bins[1].pressure(), 0);
  EXPECT_NEAR(bins[2].force.x, 2, 1e-12);
  EXPECT_NEAR(bins[2].width, 0.5, 1e-12);
  EXPECT_TRUE(profile.take(1).empty()) << "starts anew";
}

// A wall 10 m long and two rows deep. A kernel of 2.4 spacings reaches 2.18 beside a flow that is a
// spacing away: two places to either side.
TEST(LoadProfile, IsAsWideAsTheFlowNotAsTheKernelReaches) {
  const auto width_with = [](double from, double to) {
    LoadProfile profile(0, 1, 2.4);
    profile.add({0, 5.5, 0.5}, {1, 0, 0});
    for (double y = 0.5; y < 10; ++y) {
      profile.see({0.5, y, 0.5}, y > from && y < to);
      profile.see({1.5, y, 0.5}, false);
    }
    return profile.take(1).at(0).width;
  };
  EXPECT_NEAR(width_with(1, 9), 4, 1e-12);
  EXPECT_NEAR(width_with(1, 10), 7, 1e-12) << "to the end of the wall";
  EXPECT_NEAR(width_with(0, 10), 10, 1e-12);
  EXPECT_NEAR(width_with(4, 7), 1, 1e-12) << "a splash: a spacing at least";
}

TEST(Approach, TakesTheGreatestOfTheWetCellsBefore) {
  Raster ground(Grid{3, 1, 0, 1, 1, 1});
  ground.values = {5, 4, 3};
  Columns columns(ground, 0.5, 1000);
  Particles particles;
  particles.resize(2);
  particles.position = {{0.5, 0.5, 5.1}, {1.5, 0.5, 4.2}};
  particles.velocity = {{2, 0, 0}, {1, 0, 0}};
  particles.mass = {250, 750};  // 0.25 and 0.75 m deep
  columns.update(particles);
  const ApproachState both = Approach(ground, [](double, double) { return true; }).measure(columns);
  EXPECT_NEAR(both.depth, 0.75, 1e-9);
  EXPECT_NEAR(both.speed, 2, 1e-9);
  EXPECT_NEAR(both.depth_speed2, 1, 1e-9);  // 0.25 * 4, more than 0.75 * 1
  EXPECT_NEAR(both.surface, 5.25, 1e-9);
  const ApproachState second =
      Approach(ground, [](double x, double) { return x > 1; }).measure(columns);
  EXPECT_NEAR(second.surface, 4.75, 1e-9);
  EXPECT_NEAR(second.depth_speed2, 0.75, 1e-9);
}

TEST(DesignFormulas, AreThoseOfStillAndOfMovingFlow) {
  EXPECT_NEAR(hydrostatic_load(1000, 9.81, 2, 3), 58860, 1e-9);
  EXPECT_NEAR(dynamic_load(1.5, 2000, 2 * 25, 3), 450000, 1e-9);
}

}  // namespace
}  // namespace sabo
