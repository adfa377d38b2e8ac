#include "analysis/hazard_map.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;

constexpr double unset = Raster::no_data;

Raster map_row(std::vector<double> values) {
  Raster raster({static_cast<int>(values.size()), 1, 0, 1, 1, 1});
  raster.values = std::move(values);
  return raster;
}

auto are(std::vector<double> values) {
  std::vector<testing::Matcher<double>> matchers;
  for (const double value : values) matchers.push_back(NanSensitiveDoubleEq(value));
  return testing::ElementsAreArray(matchers);
}

/// Strong: deeper than 1 m and faster than 1 m/s; medium: all else.
HazardRules intensity() {
  HazardRules rules;
  rules.classes = {{"strong", "", {}, {{{HazardQuantity::depth, 1}, {HazardQuantity::speed, 1}}}},
                   {"medium", "", {}, {}}};
  return rules;
}

TEST(HazardMap, FirstClassThatFitsCounts) {
  const HazardMaps maps{{HazardQuantity::depth, map_row({2, 2, 0.5, 0.05, unset, 1})},
                        {HazardQuantity::speed, map_row({3, 0.5, 9, 9, unset, 9})}};
  EXPECT_THAT(classify(intensity(), maps, 0.05).values, are({2, 1, 1, unset, unset, 1}));
}

TEST(HazardMap, OneListOfConditionsIsEnough) {
  HazardRules rules = intensity();
  rules.classes.pop_back();
  rules.classes[0].when.push_back({{HazardQuantity::depth_speed, 8}});
  const HazardMaps maps{{HazardQuantity::depth, map_row({2, 0.9, 0.9})},
                        {HazardQuantity::speed, map_row({1.5, 10, 8})}};
  EXPECT_THAT(classify(rules, maps, 0).values, are({1, 1, unset})) << "0.9 x 8 is not above 8";
}

TEST(HazardMap, EnergyHeadIsDepthAndVelocityHead) {
  HazardRules rules;
  rules.classes = {{"red", "", {}, {{{HazardQuantity::energy_head, 1.5}}}}};
  EXPECT_THAT(quantities_of(rules), ElementsAre(HazardQuantity::depth, HazardQuantity::speed));
  // 4.43^2 / 19.62 = 1.00025 m; 4.42^2 / 19.62 = 0.99574 m.
  const HazardMaps maps{{HazardQuantity::depth, map_row({0.5, 0.5})},
                        {HazardQuantity::speed, map_row({4.43, 4.42})}};
  EXPECT_THAT(classify(rules, maps, 0).values, are({1, unset}));
}

TEST(HazardMap, StrengthOfAHouseFallsUntilTheFlowIsHalfAsHighAsTheFormulaReaches) {
  const HouseStrength house{35.3, 5.6};
  EXPECT_NEAR(house.at(1), 7.674, 5e-4);    // 35.3 / 4.6; designation sheets print 7.7
  EXPECT_NEAR(house.at(2), 4.903, 5e-4);    // 35.3 / 7.2
  EXPECT_NEAR(house.at(2.8), 4.503, 5e-4);  // 35.3 / 7.84
  EXPECT_EQ(house.at(5.5), house.at(2.8)) << "the formula would give 64 kPa";

  HazardRules rules;
  rules.house = house;
  rules.classes = {{"red", "", {}, {{{HazardQuantity::impact_over_house, 1}}}}};
  const HazardMaps maps{{HazardQuantity::depth, map_row({1, 1, 5.5})},
                        {HazardQuantity::impact, map_row({7.6, 7.7, 4.6})}};
  EXPECT_THAT(classify(rules, maps, 0).values, are({unset, 1, 1}));
}

TEST(HazardMap, LevelsComeFromTheMatrix) {
  HazardRules rules = intensity();
  rules.levels = {{"red", "", {}}, {"blue", "", {}}, {"residual", "", {}}};
  rules.matrix = HazardMatrix{{30, 100}, {{0, 0}, {0, 1}}, std::nullopt};
  const Raster classes = map_row({2, 1, unset});
  EXPECT_THAT(levels_of(classes, rules, 30).values, are({3, 3, unset}));
  EXPECT_THAT(levels_of(classes, rules, 31).values, are({3, 2, unset}));
  EXPECT_THAT(levels_of(classes, rules, 101).values, are({unset, unset, unset}));
  rules.matrix->beyond = 2;
  EXPECT_THAT(levels_of(classes, rules, 101).values, are({1, 1, unset}));
}

TEST(HazardMap, TheWorstOfSeveralCounts) {
  Raster worst = map_row({unset, 1, 2, unset});
  take_worse(map_row({1, 2, 1, unset}), worst);
  EXPECT_THAT(worst.values, are({1, 2, 2, unset}));
}

}  // namespace
}  // namespace sabo
