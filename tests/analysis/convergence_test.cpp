#include "analysis/convergence.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace sabo {
namespace {

/// 1 + 0.3 h^p
std::vector<GridSample> law(double p, const std::vector<double>& spacings) {
  std::vector<GridSample> samples;
  for (const double h : spacings) samples.push_back({h, 1 + 0.3 * std::pow(h, p)});
  return samples;
}

TEST(GridConvergence, RecoversLimitAndOrderOfAPowerLaw) {
  for (const double p : {0.5, 1., 1.37, 2., 3.}) {
    // Equal ratios, unequal ones either way, and in another order.
    for (const auto& h :
         {std::vector<double>{1, 0.5, 0.25}, {1, 0.75, 0.4}, {3, 1, 0.8}, {0.4, 1, 0.75}}) {
      const GridConvergence result = grid_convergence(law(p, h));
      EXPECT_EQ(result.kind, Convergence::monotone);
      EXPECT_NEAR(result.order, p, 1e-8) << h[0];
      EXPECT_NEAR(result.extrapolated, 1, 1e-9) << h[0];
    }
  }
}

// p = 1, h = 1 and 0.5: f = 1.3, 1.15; |change| / (2 - 1) = 0.15, and 1.25 of it.
TEST(GridConvergence, IndexOfThreeSpacings) {
  const GridConvergence result = grid_convergence(law(1, {2, 1, 0.5}));
  EXPECT_NEAR(result.uncertainty, 0.1875, 1e-9);
  EXPECT_EQ(result.lowest, 1.15);
  EXPECT_EQ(result.highest, 1.6);
}

// p = 3: 1.3, 1.0375; the index takes second order, 1.25 x 0.2625 / (4 - 1), not 0.2625 / 7.
TEST(GridConvergence, IndexTrustsNoMoreThanSecondOrder) {
  const GridConvergence result = grid_convergence(law(3, {2, 1, 0.5}));
  EXPECT_NEAR(result.uncertainty, 1.25 * 0.2625 / 3, 1e-9);
  EXPECT_NEAR(result.extrapolated, 1, 1e-9);
}

// f = 1 + 0.3 h of h = 1 and 0.6: first order is right here, 1.18 - 0.12 x 0.6 / 0.4 = 1.
// The index is 3 x 0.12 / (1 / 0.6 - 1) = 0.54.
TEST(GridConvergence, OfTwoSpacingsAssumesFirstOrder) {
  const GridConvergence result = grid_convergence(law(1, {1, 0.6}));
  EXPECT_EQ(result.kind, Convergence::first_order);
  EXPECT_EQ(result.order, 1);
  EXPECT_NEAR(result.extrapolated, 1, 1e-12);
  EXPECT_NEAR(result.uncertainty, 0.54, 1e-12);
}

TEST(GridConvergence, TakesTheThreeFinest) {
  auto samples = law(2, {1, 0.5, 0.25});
  samples.push_back({2, -40});
  const GridConvergence result = grid_convergence(samples);
  EXPECT_EQ(result.kind, Convergence::monotone);
  EXPECT_NEAR(result.order, 2, 1e-8);
  EXPECT_EQ(result.lowest, -40) << "the range is that of all";
}

TEST(GridConvergence, GivesNoOrderWhereThereIsNone) {
  const auto kind = [](double coarse, double middle, double fine) {
    return grid_convergence(std::vector<GridSample>{{1, coarse}, {0.5, middle}, {0.25, fine}}).kind;
  };
  EXPECT_EQ(kind(1, 3, 2), Convergence::no_order) << "up and down";
  EXPECT_EQ(kind(1, 2, 3), Convergence::no_order) << "equal steps: order 0";
  EXPECT_EQ(kind(1, 2, 4), Convergence::no_order) << "growing steps";
  EXPECT_EQ(kind(1, 2, 2), Convergence::no_order) << "infinite order";
  EXPECT_EQ(kind(1, 1, 2), Convergence::no_order);
  EXPECT_EQ(kind(1, 2.1, 3), Convergence::monotone);
}

TEST(GridConvergence, OfEqualValuesIsTheValue) {
  const GridConvergence result =
      grid_convergence(std::vector<GridSample>{{1, 7}, {0.5, 7}, {0.3, 7}});
  EXPECT_EQ(result.kind, Convergence::unchanged);
  EXPECT_EQ(result.extrapolated, 7);
  EXPECT_EQ(result.uncertainty, 0);
  EXPECT_EQ(grid_convergence(std::vector<GridSample>{{1, 0}, {0.5, 0}}).kind,
            Convergence::unchanged);
}

TEST(GridConvergence, OfOneSpacingHasNoLimit) {
  EXPECT_FALSE(grid_convergence(std::vector<GridSample>{{1, 7}}).has_limit());
  EXPECT_FALSE(grid_convergence({}).has_limit());
}

TEST(GridConvergence, IsFiniteForAllValues) {
  EXPECT_TRUE(rc::check("no NaN, no infinity", [] {
    const auto value = [] { return *rc::gen::inRange(-1000, 1000) / 7.0; };
    const double fine = *rc::gen::inRange(1, 1000) / 100.0;
    const double middle = fine * (1 + *rc::gen::inRange(1, 300) / 100.0);
    const double coarse = middle * (1 + *rc::gen::inRange(1, 300) / 100.0);
    const GridConvergence result = grid_convergence(
        std::vector<GridSample>{{fine, value()}, {middle, value()}, {coarse, value()}});
    RC_ASSERT(std::isfinite(result.order) && std::isfinite(result.extrapolated) &&
              std::isfinite(result.uncertainty));
    RC_ASSERT(result.uncertainty >= 0);
  }));
}

// 2, 4, 9: mean 5, squares 9 + 1 + 16 = 26 over 2.
TEST(Scatter, HasMeanAndDeviation) {
  const std::vector<double> values{2, 4, 9};
  EXPECT_DOUBLE_EQ(scatter_of(values).mean, 5);
  EXPECT_DOUBLE_EQ(scatter_of(values).deviation, std::sqrt(13.));
  EXPECT_EQ(scatter_of(std::vector<double>{3}).deviation, 0);
}

}  // namespace
}  // namespace sabo
