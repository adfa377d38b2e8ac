#include "run/key_quantities.hpp"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::Contains;
using testing::Key;
using testing::Not;

constexpr double dry = Raster::no_data;

/// Six cells of 2 m down a channel with a dam at x = 6 and a section at x = 3 of the same name.
class KeyQuantities : public testing::Test {
 protected:
  KeyQuantities() {
    scene_.dams.push_back({"wall", {{{6, 0, 0}, {6, 2, 0}}}, 0, 1, {}});
    scene_.sections.push_back({"wall", {{{3, 0, 0}, {3, 2, 0}}}});
    maps_.deposit = maps_.arrival = Raster({6, 1, 0, 2, 2, 2});
    maps_.deposit.values = {0.5, 1.5, 0.04, 0, dry, 0};
    maps_.arrival.values = {0, 4, 7, dry, dry, dry};
    SeriesRow row;
    row.front = {10, 0, 0};
    row.discharge = {0};
    row.volumes = {{12, 12, 0, 0, 0}};
    row.basins = {{}};
    rows_.push_back(row);
    row.front = {16, 6, 3};
    row.discharge = {-5};
    rows_.push_back(row);
    row.front = {15, 5, -0.5};
    row.discharge = {2};
    row.volumes = {{12, 8, 3, 1, 0}};
    row.basins = {{7, 0.5, 2}};
    rows_.push_back(row);
  }

  std::map<std::string, double> found() const {
    std::map<std::string, double> values;
    for (const KeyQuantity& quantity : key_quantities(maps_, rows_, scene_)) {
      EXPECT_FALSE(values.contains(quantity.label())) << "twice: " << quantity.label();
      values[quantity.label()] = quantity.value;
    }
    return values;
  }

  Scene scene_;
  RunMaps maps_;
  std::vector<SeriesRow> rows_;
};

TEST_F(KeyQuantities, SumUpARun) {
  const auto values = found();
  EXPECT_EQ(values.at("front run-out [m]"), 5) << "at the end, not the farthest";
  EXPECT_EQ(values.at("peak front speed [m/s]"), 3);
  // Half the thickness and a cell before the axis at 6 m: from 3.5 m on, the cell of 3 m.
  EXPECT_EQ(values.at("arrival at wall [s]"), 4);
  EXPECT_EQ(values.at("trapped by wall [m3]"), 8);
  EXPECT_EQ(values.at("stored in the basin of wall [m3]"), 7);
  EXPECT_EQ(values.at("beyond wall [m3]"), 3);
  EXPECT_EQ(values.at("arrival at section wall [s]"), 4);
  EXPECT_EQ(values.at("peak discharge at section wall [m3/s]"), 5) << "in either direction";
  EXPECT_EQ(values.at("left the map [m3]"), 1);
  EXPECT_EQ(values.at("deposit area [m2]"), 8) << "a film of 4 cm is none";
  EXPECT_EQ(values.at("deposit mean depth [m]"), 1);
}

TEST_F(KeyQuantities, LeaveOutWhatNeverCame) {
  maps_.arrival.values = {0, dry, dry, dry, dry, dry};
  maps_.deposit.values = {0, 0, 0, 0, dry, 0};
  const auto values = found();
  EXPECT_THAT(values, Not(Contains(Key("arrival at wall [s]"))));
  EXPECT_EQ(values.at("deposit mean depth [m]"), 0);
}

TEST_F(KeyQuantities, NeedRows) {
  rows_.clear();
  EXPECT_TRUE(found().empty());
}

TEST_F(KeyQuantities, RunOutIsTheFarthestWhereFlowHasLeftTheMap) {
  rows_.back().front.displacement = -3;  // of what stayed behind
  EXPECT_EQ(found().at("front run-out [m]"), -3);
  rows_.back().left.mass = 1;
  EXPECT_EQ(found().at("front run-out [m]"), 6);
}

}  // namespace
}  // namespace sabo
