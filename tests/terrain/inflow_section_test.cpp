#include "terrain/inflow_section.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

/// A channel along x whose bed is level, 4 m wide, with sides of 1:1 up to `banks` (m), and falls
/// by `slope` (m/m) along x; vertices every metre.
Surface channel(double slope = 0, double banks = 10) {
  Raster bed(Grid{41, 25, -20.5, 12.5, 1, 1}, 0.0);
  for (int row = 0; row < 25; ++row)
    for (int column = 0; column < 41; ++column)
      bed.at(column, row) = std::min(banks, std::max(0.0, std::abs(bed.grid.y_of(row)) - 2)) -
                            slope * bed.grid.x_of(column);
  return Surface(bed);
}

const Polyline across{{{0, -6, 0}, {0, 6, 0}}, false};  // the right side is downstream

TEST(InflowSection, HasTheAreaAndWidthOfATrapezoid) {
  const Surface surface = channel();
  const InflowSection section(surface, across, false, 0.5, 3);
  EXPECT_NEAR(section.area(1), 4 + 1, 1e-9);  // bottom and two triangles
  EXPECT_NEAR(section.width(1), 6, 1e-9);
  EXPECT_NEAR(section.level_of(5), 1, 1e-9);
  EXPECT_EQ(section.columns().size(), 24u);
}

TEST(InflowSection, FindsTheLevelOfADischarge) {
  const Surface surface = channel();
  const InflowSection section(surface, across, false, 0.5, 3);
  const SectionFlow given = section.at_speed(10, 2);  // 5 m2
  EXPECT_NEAR(given.level, 1, 1e-9);
  EXPECT_NEAR(given.depth, 1, 1e-9);
  EXPECT_EQ(given.speed, 2);
  // Critical: u = sqrt(g A/B) = sqrt(9.81 x 5/6) = 2.8592 m/s, Q = 14.296 m3/s.
  const double speed = std::sqrt(9.81 * 5 / 6);
  const SectionFlow critical = section.at_froude(5 * speed, 1, 9.81);
  EXPECT_NEAR(critical.level, 1, 1e-9);
  EXPECT_NEAR(critical.speed, 2.8592, 1e-4);
  EXPECT_NEAR(section.at_froude(2 * 5 * speed, 2, 9.81).level, 1, 1e-9);
}

TEST(InflowSection, CountsSpeedAlongTheBedAndDepthNormalToIt) {
  const Surface surface = channel(0.75);  // 3-4-5: the cosine is 0.8
  const InflowSection section(surface, across, false, 0.5, 3);
  EXPECT_NEAR(section.fall(), 0.75, 1e-12);
  EXPECT_NEAR(section.cosine(), 0.8, 1e-12);
  // Of the vertical section: Q = A u cos.
  EXPECT_NEAR(section.at_speed(10, 2.5).level, 1, 1e-9);
  // u = sqrt(g cos h), h = cos A/B.
  EXPECT_NEAR(section.froude_speed(1, 1, 9.81), 0.8 * std::sqrt(9.81), 1e-12);
}

TEST(InflowSection, KnowsWhatIsInFrontOfIt) {
  const Surface surface = channel();
  const InflowSection right(surface, across, false, 0.5, 3);
  EXPECT_NEAR(right.distance({2, 1, 7}), 2, 1e-12);
  EXPECT_TRUE(right.holds({2, 1, 0}, 3));
  EXPECT_FALSE(right.holds({3.1, 1, 0}, 3));
  EXPECT_FALSE(right.holds({2, 6.1, 0}, 3));
  EXPECT_NEAR(InflowSection(surface, across, true, 0.5, 3).distance({2, 1, 7}), -2, 1e-12);
  // A bent line is moved as it is along the normal of its chord.
  const Polyline bent{{{0, -6, 0}, {1, 0, 0}, {0, 6, 0}}, false};
  EXPECT_NEAR(InflowSection(surface, bent, false, 0.5, 3).distance({2, 0, 0}), 1, 1e-12);
}

TEST(InflowSection, RefusesALineThatTurnsBack) {
  EXPECT_FALSE(InflowSection::turns_back(across));
  EXPECT_TRUE(InflowSection::turns_back({{{0, 0, 0}, {0, 4, 0}, {1, 3, 0}, {0, 6, 0}}, false}));
  EXPECT_TRUE(InflowSection::turns_back({{{0, 0, 0}, {0, 0, 0}}, false}));
}

}  // namespace
}  // namespace sabo
