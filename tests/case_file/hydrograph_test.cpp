#include "case/hydrograph.hpp"

#include <gtest/gtest.h>

namespace sabo {
namespace {

TEST(Hydrograph, IsStraightBetweenItsRowsAndZeroOutside) {
  const Hydrograph h{{10, 20, 40}, {0, 8, 2}, {}};
  EXPECT_EQ(h.discharge_at(9), 0);
  EXPECT_EQ(h.discharge_at(15), 4);
  EXPECT_EQ(h.discharge_at(20), 8);
  EXPECT_EQ(h.discharge_at(30), 5);
  EXPECT_EQ(h.discharge_at(40), 2);
  EXPECT_EQ(h.discharge_at(41), 0);
  EXPECT_EQ(h.volume_until(10), 0);
  EXPECT_EQ(h.volume_until(15), 10);  // 5 s x 4 / 2
  EXPECT_EQ(h.volume_until(20), 40);
  EXPECT_EQ(h.volume_until(30), 40 + 65);
  EXPECT_EQ(h.volume(), 140);
  EXPECT_EQ(h.volume_until(1000), 140);
  EXPECT_EQ(h.peak(), 1u);
  EXPECT_EQ(h.end(), 40);
}

TEST(Hydrograph, TakesSpeedsFromRowsThatHaveDischarge) {
  const Hydrograph h{{0, 10, 20, 30, 40}, {0, 1, 3, 0, 0}, {0, 2, 4, 0, 9}};
  EXPECT_EQ(h.speed_at(0), 2);
  EXPECT_EQ(h.speed_at(5), 2);
  EXPECT_EQ(h.speed_at(10), 2);
  EXPECT_EQ(h.speed_at(15), 3);
  EXPECT_EQ(h.speed_at(20), 4);
  EXPECT_EQ(h.speed_at(29), 4);
  EXPECT_EQ(h.speed_at(50), 4);
  EXPECT_EQ(h.end(), 30);
}

TEST(Hydrograph, AddsSurgesThatOverlap) {
  const Hydrograph h = hydrograph_of({{0, 10, 20, 6}, {10, 20, 30, 4}});
  EXPECT_EQ(h.discharge_at(10), 6);
  EXPECT_EQ(h.discharge_at(15), 3 + 2);
  EXPECT_EQ(h.discharge_at(20), 4);
  EXPECT_EQ(h.volume(), 60 + 40);
}

TEST(Hydrograph, LetsASurgeBeginOrEndWithAJump) {
  const Hydrograph front = hydrograph_of({{5, 5, 15, 6}});
  EXPECT_EQ(front.discharge_at(4.9), 0);
  EXPECT_EQ(front.discharge_at(5), 6);
  EXPECT_EQ(front.discharge_at(10), 3);
  EXPECT_NEAR(front.volume(), 30, 1e-9);
  const Hydrograph tail = hydrograph_of({{5, 15, 15, 6}, {20, 25, 30, 2}});
  EXPECT_EQ(tail.discharge_at(10), 3);
  EXPECT_EQ(tail.discharge_at(15.1), 0);
  EXPECT_NEAR(tail.volume(), 30 + 10, 1e-9);
}

}  // namespace
}  // namespace sabo
