#include "analysis/rest.hpp"

#include <cmath>
#include <functional>

#include "cloud.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

constexpr double spacing = 0.5;
const RestLimits limits{10, 0.01, 0.01, 1e-4, 1};

/// A hundred particles of 1 m3 in a row, each moved along x by a function of its number and time.
class Flow {
 public:
  using Path = std::function<double(int number, double time)>;
  explicit Flow(Path path) : path_(std::move(path)) {}

  Particles at(double time) const {
    std::vector<Vec3d> positions;
    for (int k = 0; k < count; ++k) positions.push_back({path_(k, time), 1. * k, 0});
    Particles particles = cloud(positions, 1000);
    constexpr double step = 1e-4;  // s
    for (int k = 0; k < count; ++k)
      particles.velocity[k].x = (path_(k, time + step) - path_(k, time)) / step;
    return particles;
  }

  /// First time at which the watch says rest, looked at each half second; -1 for never.
  double rest_within(double end, RestWatch watch) const {
    for (double time = 0; time <= end; time += 0.5) {
      const bool may_find_rest = watch.may_find_rest(time);
      watch.update(time, at(time));
      if (!watch.state().is_at_rest) continue;
      EXPECT_TRUE(may_find_rest);
      return time;
    }
    return -1;
  }

  static constexpr int count = 100;

 private:
  Path path_;
};

RestWatch watch() { return {limits, spacing, 1000}; }

/// 5 m/s for 20 s, then nothing.
double slide(double time) { return 5 * std::min(time, 20.0); }

TEST(Rest, ComesWhenTheTimeHasPassedSinceTheLastMotion) {
  const Flow flow([](int, double time) { return slide(time); });
  // The first kept state at rest is that at 20 s: the watch keeps one each 2.5 s.
  EXPECT_EQ(flow.rest_within(60, watch()), 30);
}

TEST(Rest, IsNotToBeFoundBeforeTheTimeHasPassed) {
  const Flow flow([](int, double time) { return slide(time); });
  RestWatch watcher = watch();
  for (double time = 0; time < 20; time += 0.5) {
    watcher.update(time, flow.at(time));
    EXPECT_FALSE(watcher.may_find_rest(time + 0.5));
  }
  watcher.update(20, flow.at(20));  // energy is low from here on
  EXPECT_FALSE(watcher.may_find_rest(29));
  EXPECT_TRUE(watcher.may_find_rest(29.5));
}

TEST(Rest, IsNotWhatHasNotMovedYet) {
  const Flow still([](int, double) { return 0.; });
  EXPECT_EQ(still.rest_within(100, watch()), -1);
  // Nor what has trembled by less than a spacing.
  const Flow settled([](int, double time) { return 0.4 * std::min(time, 1.0); });
  EXPECT_EQ(settled.rest_within(100, watch()), -1);
}

TEST(Rest, WaitsForMassThatStartsLater) {
  const Flow flow([](int number, double time) {
    return number < 50 ? slide(time) : slide(time - 100 > 0 ? time - 100 : 0);
  });
  EXPECT_EQ(flow.rest_within(80, {limits, spacing, 1000}), 30);
  EXPECT_EQ(flow.rest_within(200, {limits, spacing, 1000, 100}), 130);
}

TEST(Rest, TrembleIsNoMotion) {
  // 5 cm/s at the most, 1 mm to and fro; energy (0.05 / 5)^2 = 1e-4 of the peak at the most.
  const Flow flow(
      [](int number, double time) { return slide(time) + 0.00099 * std::sin(50 * time + number); });
  EXPECT_EQ(flow.rest_within(60, watch()), 30);
}

TEST(Rest, SteadyCreepIsMotion) {
  // 1.2 cm/s of two in a hundred: more than 1 % of the volume above 1 cm/s.
  const Flow few(
      [](int number, double time) { return slide(time) + (number < 2 ? 0.012 * time : 0); });
  EXPECT_EQ(few.rest_within(200, watch()), -1);
  // One in a hundred is at the limit.
  const Flow one(
      [](int number, double time) { return slide(time) + (number < 1 ? 0.012 * time : 0); });
  EXPECT_EQ(one.rest_within(200, watch()), 30);
  // 9 mm/s of all: below 1 cm/s, but 1.08 spacings of 0.5 m a minute; 8 mm/s are 0.96.
  const Flow fast([](int, double time) { return slide(time) + 0.009 * time; });
  EXPECT_EQ(fast.rest_within(200, watch()), -1);
  const Flow slow([](int, double time) { return slide(time) + 0.008 * time; });
  EXPECT_EQ(slow.rest_within(200, watch()), 30);
}

TEST(Rest, EnergyIsComparedWithItsPeak) {
  // 6 cm/s over 1 mm: no displacement, but (0.06 / 5)^2 = 1.44e-4 of the peak energy.
  const Flow flow([](int, double time) { return slide(time) + 0.0012 * std::sin(50 * time); });
  EXPECT_EQ(flow.rest_within(60, {{10, 0.01, 0.01, 1.5e-4, 1}, spacing, 1000}), 30);
  RestWatch strict({10, 0.01, 0.01, 1e-5, 1}, spacing, 1000);
  EXPECT_EQ(flow.rest_within(60, strict), -1);
}

TEST(Rest, StateHasItsNumbers) {
  RestWatch seen = watch();
  const Flow flow([](int number, double time) { return number < 25 ? 2 * time : 0.; });
  seen.update(0, flow.at(0));
  EXPECT_EQ(seen.state().moving_volume, 0);
  seen.update(4, flow.at(4));
  EXPECT_EQ(seen.state().moving_volume, 25);
  EXPECT_EQ(seen.state().moving_share, 0.25);
  EXPECT_NEAR(seen.state().energy_share, 1, 1e-9);
  // A quarter goes 8 m in 4 s: 2 m or 4 spacings in the mean, 60 a minute.
  EXPECT_NEAR(seen.state().creep, 60, 1e-9);
  EXPECT_TRUE(seen.state().has_moved);
}

TEST(Rest, WhatLeftTheMapHasMovedAndIsNoMore) {
  RestWatch seen = watch();
  Particles all = Flow([](int, double) { return 0.; }).at(0);
  seen.update(0, all);
  std::vector<std::uint32_t> rows;
  for (std::uint32_t k = 0; k < 50; ++k) rows.push_back(2 * k);
  all.permute(rows);
  for (double time = 1; time < 11; time += 1) seen.update(time, all);
  EXPECT_TRUE(seen.state().has_moved);
  EXPECT_TRUE(seen.state().is_at_rest);
  EXPECT_EQ(seen.state().moving_volume, 0);
}

TEST(Rest, NoParticlesAreNoRest) {
  RestWatch seen = watch();
  seen.update(0, {});
  seen.update(20, {});
  EXPECT_FALSE(seen.state().is_at_rest);
  EXPECT_EQ(seen.state().creep, 0);
}

}  // namespace
}  // namespace sabo
