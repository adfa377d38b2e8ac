#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "run/exceedance.hpp"
#include "run/sweep_page.hpp"
#include "run/sweep_plan.hpp"

namespace sabo {
namespace {

std::vector<std::string> texts_of(const Variation& variation) {
  std::vector<std::string> texts;
  for (const auto& value : variation.values) texts.push_back(value_text(value));
  return texts;
}

TEST(Variation, HoldsListsAndRanges) {
  const Variation list = read_variation("material.friction_angle=25,30.5");
  EXPECT_EQ(list.name(), "material.friction_angle");
  EXPECT_THAT(texts_of(list), testing::ElementsAre("25", "30.5"));
  const Variation range = read_variation("material.pore_pressure_ratio=0:0.3:0.1");
  EXPECT_THAT(texts_of(range), testing::ElementsAre("0", "0.1", "0.2", "0.3"));
  EXPECT_EQ(read_variation("structure[2].height=4").key.table, "structure[2]");
  const Variation seeds = read_variation("release.seed=1:5:2");
  EXPECT_THAT(texts_of(seeds), testing::ElementsAre("1", "3", "5"));
  EXPECT_TRUE(std::holds_alternative<std::int64_t>(seeds.values[0]));
  EXPECT_THAT(texts_of(read_variation("release.normal=true,false")),
              testing::ElementsAre("true", "false"));
  EXPECT_THAT(texts_of(read_variation("numerics.wall=coulomb")), testing::ElementsAre("coulomb"));
}

TEST(Variation, RefusesWhatItCannotRead) {
  for (const char* text : {"", "volume=3", "release.volume", "release.volume=", "release.volume=1,",
                           "a.b=1:2", "a.b=1:2:0", "a.b=2:1:1", "a.b=0:1:1e-9", "a.b=0:x:1"})
    EXPECT_THROW(read_variation(text), CaseError) << text;
}

TEST(Exceedance, IsTheShareOfTheRuns) {
  const Grid grid{3, 1, 0, 1, 1, 1};
  Raster a(grid), b(grid);
  a.values = {0.6, 0.4, Raster::no_data};
  b.values = {2, 0.8, Raster::no_data};
  const Raster share = share_above({a, b}, 0.5);
  EXPECT_EQ(share.values[0], 1);
  EXPECT_EQ(share.values[1], 0.5);
  EXPECT_TRUE(std::isnan(share.values[2]));
  EXPECT_EQ(share_above({a, b}, 0.6).values[0], 0.5) << "above, not at";
}

TEST(SweepTable, LeavesOutWhatARunHasNot) {
  BatchRecord first, second;
  first.quantities = {{"run-out [m]", 12.5}};
  second.quantities = {{"run-out [m]", 14}, {"arrival [s]", 3}};
  const SweepTable table{{"material.cohesion"}, {{{"0"}, first}, {{"50"}, second}}};
  const PageTable page = sweep_table(table);
  EXPECT_THAT(page.header, testing::ElementsAre("material.cohesion", "run-out [m]", "arrival [s]"));
  EXPECT_THAT(page.rows[0], testing::ElementsAre("0", "12.50", "-"));
  EXPECT_THAT(page.rows[1], testing::ElementsAre("50", "14.00", "3.000"));
}

}  // namespace
}  // namespace sabo
