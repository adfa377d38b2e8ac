#include "analysis/footprint_score.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace sabo {
namespace {

constexpr double none = Raster::no_data;

std::vector<std::size_t> all_of(const Raster& raster) {
  std::vector<std::size_t> cells(raster.values.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return cells;
}

Raster row_of(std::vector<double> values) {
  Raster raster({static_cast<int>(values.size()), 1, 0, 2, 3, 2});  // cells of 6 m2
  raster.values = std::move(values);
  return raster;
}

TEST(FootprintScore, CountsAreasAsDrawnByHand) {
  const Raster simulated = row_of({1, 0.5, 0.2, 0.1, 0, none});
  const Raster observed = row_of({2, 0.05, 0.9, 0.3, 0, 0});
  const FootprintPair pair{simulated, observed, 0.1, 0.1};
  // Hit: cells 0 and 2. False: 1. Missed: 3, where 0.1 is not above the threshold.
  const FootprintScore score = footprint_score(pair, all_of(simulated));
  EXPECT_EQ(score.hit, 12);
  EXPECT_EQ(score.false_alarm, 6);
  EXPECT_EQ(score.miss, 6);
  EXPECT_DOUBLE_EQ(score.csi(), 0.5);
  EXPECT_DOUBLE_EQ(score.precision(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.recall(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.bias(), 1);
  EXPECT_NEAR(score.omega(), 0, 1e-15) << "2/3 - 1/3 - 1/3";
  EXPECT_EQ(footprint_score(pair, {0, 1}).csi(), 0.5) << "only the cells asked for";
}

TEST(FootprintScore, DepthErrorIsThatOfTheHitCells) {
  const Raster simulated = row_of({1, 0.5, 3});
  const Raster observed = row_of({2, 0, 1});
  const DepthError error = depth_error({simulated, observed, 0.1, 0.1}, all_of(simulated));
  EXPECT_EQ(error.area, 12);
  EXPECT_DOUBLE_EQ(error.mean, 0.5);           // (-1 + 2) / 2
  EXPECT_DOUBLE_EQ(error.mean_absolute, 1.5);  // (1 + 2) / 2
  EXPECT_DOUBLE_EQ(error.root_mean_square, std::sqrt(2.5));
  EXPECT_EQ(depth_error({simulated, observed, 9, 0.1}, all_of(simulated)).area, 0);
}

Raster any_row(std::size_t size) {
  std::vector<double> values;
  for (std::size_t k = 0; k < size; ++k) {
    const int tenths = *rc::gen::inRange(-1, 4);
    values.push_back(tenths < 0 ? none : tenths);
  }
  return row_of(std::move(values));
}

TEST(FootprintScore, HoldsItsLaws) {
  EXPECT_TRUE(rc::check("areas add up; the roles of the two swap misses and false alarms", [] {
    const auto size = *rc::gen::inRange<std::size_t>(1, 40);
    const Raster a = any_row(size), b = any_row(size);
    const auto cells = all_of(a);
    const FootprintScore score = footprint_score({a, b, 1, 1}, cells);
    const FootprintScore swapped = footprint_score({b, a, 1, 1}, cells);
    double observed = 0;
    for (const double value : b.values) observed += value > 1 ? 6 : 0;
    RC_ASSERT(score.hit + score.miss == observed);
    RC_ASSERT(score.hit == swapped.hit);
    RC_ASSERT(score.miss == swapped.false_alarm);
    RC_ASSERT(depth_error({a, b, 1, 1}, cells).mean == -depth_error({b, a, 1, 1}, cells).mean);
    const FootprintScore same = footprint_score({b, b, 1, 1}, cells);
    RC_ASSERT(same.miss == 0 && same.false_alarm == 0);
    if (observed > 0) RC_ASSERT(same.csi() == 1 && same.omega() == 1);
  }));
}

}  // namespace
}  // namespace sabo
