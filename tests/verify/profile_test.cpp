#include "verify/profile.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(Profile, ErrorIsARootMeanSquareOverThatOfTheExactSpeed) {
  Particles fluid;
  fluid.resize(2);
  fluid.position = {{0, 0, 3}, {0, 0, 4}};
  fluid.velocity = {{3.5, 9, 9}, {4, 0, 0}};
  EXPECT_NEAR(profile_error(fluid, [](double z) { return z; }), 0.1, 1e-12);  // 0.5 over 5
}

TEST(Profile, SeriesIsInOrderOfHeight) {
  Particles fluid;
  fluid.resize(2);
  fluid.position = {{0, 0, 4}, {0, 0, 3}};
  fluid.velocity = {{1, 0, 0}, {2, 0, 0}};
  const ChartSeries series = profile_series("a", fluid);
  EXPECT_EQ(series.x, (std::vector<double>{3, 4}));
  EXPECT_EQ(series.y, (std::vector<double>{2, 1}));
}

TEST(Profile, OrderIsTheSlopeOnLogarithmicAxes) {
  EXPECT_NEAR(order_of({"", {1, 2, 4}, {3, 12, 48}}), 2, 1e-12);
  // Equal ratios of spacings: the middle one does not matter.
  EXPECT_NEAR(order_of({"", {1, 2, 4}, {1, 9, 4}}), 1, 1e-12);
  EXPECT_NEAR(order_of({"", {1, 2}, {5, 5}}), 0, 1e-12);
}

}  // namespace
}  // namespace sabo
