#include "verify/water.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

/// 2 for one second, then 6.
TimeIntegral stairs() {
  TimeIntegral integral;
  for (int k = 1; k <= 40; ++k) integral.go_on(0.05 * k, k <= 20 ? 2 : 6);
  return integral;
}

TEST(TimeIntegral, GivesMeansOverAnyTime) {
  const TimeIntegral integral = stairs();
  EXPECT_NEAR(integral.integral(0, 2), 8, 1e-12);
  EXPECT_NEAR(integral.mean(0.5, 1.5), 4, 1e-12);
  EXPECT_NEAR(integral.around(1.025, 0.1), 5, 1e-12);  // a quarter of it at 2
}

TEST(TimeIntegral, FindsItsPeakAndWhenItRises) {
  TimeIntegral integral = stairs();
  EXPECT_NEAR(integral.rises_above(4, 0.1), 1.05, 1e-9);
  EXPECT_TRUE(std::isnan(integral.rises_above(7, 0.1)));
  integral.go_on(2.1, 16);
  integral.go_on(3, 0);
  const TimeIntegral::Peak peak = integral.peak(0.2, 0.5, 3);
  EXPECT_NEAR(peak.value, 11, 1e-9);  // 0.1 s at 16, as much at 6
  EXPECT_NEAR(peak.time, 2, 0.021);
}

TEST(TimeIntegral, IsDrawnAsMeansOfItsSteps) {
  const ChartSeries series = stairs().series("a", 0.5, 2);
  ASSERT_EQ(series.x.size(), 4u);
  EXPECT_NEAR(series.x[2], 1.25, 1e-12);
  EXPECT_NEAR(series.y[1], 2, 1e-12);
  EXPECT_NEAR(series.y[2], 6, 1e-12);
}

TEST(MeasuredSeries, IsMarkersAtItsTimes) {
  const ChartSeries series = measured_series("b", 0.3, 0.02, {1, 2, 3});
  EXPECT_NEAR(series.x[2], 0.34, 1e-12);
  EXPECT_EQ(series.y[2], 3);
  EXPECT_TRUE(series.has_markers);
  EXPECT_FALSE(series.has_line);
}

}  // namespace
}  // namespace sabo
