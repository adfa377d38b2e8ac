#include "app/progress_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace sabo {
namespace {

using testing::HasSubstr;

RunProgress halfway() {
  RunProgress p;
  p.time = 60;
  p.duration = 120;
  p.wall = 90;
  p.steps = 1800;
  p.dt = 0.00125;
  p.fastest = 14.24;
  p.front = {512.3, 400, 9.81};
  p.volumes = {8863, 8743, 120, 0, 0};
  return p;
}

TEST(ProgressLine, SaysHowARunStands) {
  Pace pace;
  pace.update({});
  pace.update(halfway());
  EXPECT_EQ(progress_text(halfway(), pace, true, 200),
            " 50 %  60.0/120 s  1:30 left  front 512 m 9.8 m/s  fastest 14.2 m/s  "
            "trapped 8743 beyond 120 m3  20 steps/s  dt 1.25 ms");
}

TEST(ProgressLine, WithoutADamNothingIsTrapped) {
  Pace pace;
  RunProgress p = halfway();
  p.volumes.outflow = 7;
  EXPECT_THAT(progress_text(p, pace, false, 200), HasSubstr("  on the map 8863 left 7 m3  "));
}

TEST(ProgressLine, HalfTheBarIsFilledHalfway) {
  const std::string bar = progress_bar(halfway(), Pace{}, true, 51);
  EXPECT_EQ(bar, "[==========          ]  50 %  60.0/120 s  -:-- left");
}

TEST(ProgressLine, FitsAnyWidth) {
  rc::check([] {
    RunProgress p = halfway();
    p.time = *rc::gen::inRange(0, 130);
    p.steps = *rc::gen::arbitrary<unsigned>();
    const int width = *rc::gen::inRange(1, 250);
    Pace pace;
    pace.update(p);
    RC_ASSERT(progress_bar(p, pace, true, width).size() <= static_cast<std::size_t>(width));
  });
}

TEST(Pace, KnowsNothingBeforeTheRunHasMoved) {
  Pace pace;
  EXPECT_FALSE(pace.seconds_left());
  RunProgress p = halfway();
  p.time = 0;
  pace.update(p);
  EXPECT_FALSE(pace.seconds_left());
}

TEST(Pace, BeginsWhereTheRunDoes) {
  Pace pace;
  RunProgress p = halfway();
  pace.update(p);
  EXPECT_FALSE(pace.seconds_left());
  p.wall += 1;
  p.time += 2;
  pace.update(p);
  EXPECT_NEAR(*pace.seconds_left(), 29, 1e-9);  // 58 s at 2 s a second
}

TEST(Pace, ForgetsTheDistantPast) {
  // A minute at 10 steps a second, then ten minutes at 30: what came before 20 s has little weight.
  Pace pace;
  RunProgress p;
  p.duration = 1000;
  for (int second = 1; second <= 660; ++second) {
    p.wall = second;
    p.steps += second <= 60 ? 10 : 30;
    p.time += second <= 60 ? 0.1 : 0.3;
    pace.update(p);
  }
  EXPECT_NEAR(pace.steps_per_second(), 30, 1e-6);
  EXPECT_NEAR(*pace.seconds_left(), (1000 - 186) / 0.3, 1e-3);
}

}  // namespace
}  // namespace sabo
