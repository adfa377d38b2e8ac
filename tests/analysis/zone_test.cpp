#include "analysis/zone.hpp"

#include "cloud.hpp"
#include <gtest/gtest.h>

#include "analysis/columns.hpp"

namespace sabo {
namespace {

Polygon rectangle(double west, double east) {
  return {{{{west, 0, 0}, {east, 0, 0}, {east, 4, 0}, {west, 4, 0}}}};
}

/// 5 x 2 cells of 2 m from (0, 0).
Raster two_rows() { return Raster({5, 2, 0, 4, 2, 2}, 0); }

TEST(Zone, MeansAreOverWetCellsAndOverTheWholeZone) {
  const Zone zone(two_rows(), {rectangle(0, 6)});  // three columns of two cells
  EXPECT_EQ(zone.area(), 24);
  // Depths of the cells by index: 0.4 and 0.2 are wet, the film of 0.03 m is not, 9 lies outside.
  const double depths[] = {0.4, 0.03, 0, 0, 9, 0.2, 0, 0, 0, 9};
  const ZoneDepth depth = zone.measure([&](std::size_t cell) { return depths[cell]; }, 0.05);
  EXPECT_DOUBLE_EQ(depth.volume, 4 * 0.63);
  EXPECT_DOUBLE_EQ(depth.wet_area, 8);
  EXPECT_DOUBLE_EQ(depth.mean_wet, 0.3);
  EXPECT_DOUBLE_EQ(depth.mean_all, 0.63 / 6);
  EXPECT_DOUBLE_EQ(depth.greatest, 0.4);
}

TEST(Zone, DryAndEmptyZonesAreZero) {
  const ZoneDepth dry =
      Zone(two_rows(), {rectangle(0, 6)}).measure([](std::size_t) { return 0.0; }, 0.05);
  EXPECT_EQ(dry.mean_wet, 0);
  const Zone empty(two_rows(), {rectangle(100, 200)});
  EXPECT_TRUE(empty.is_empty());
  EXPECT_EQ(empty.measure([](std::size_t) { return 1.0; }, 0.05).mean_all, 0);
}

TEST(Zone, LeavesOutCellsOutsideTheDomain) {
  Raster holed = two_rows();
  holed.at(1, 1) = Raster::no_data;
  EXPECT_EQ(Zone(holed, {rectangle(0, 6)}).area(), 20);
}

// Two particles in one cell, 0.4 m in all, with 3 and 7 kPa: the column has the greater pressure.
TEST(Columns, PressureIsTheGreatestOfTheColumn) {
  Columns columns(two_rows(), 0.5, 1000);
  Particles two = cloud({{1, 1, 0}, {1, 1, 1}}, 800);
  two.pressure = {7000, 3000};
  two.velocity[0] = {3, 0, 4};
  columns.update(two);
  EXPECT_EQ(columns.pressure().at(0, 1), 7000);
  EXPECT_EQ(columns.speed().at(0, 1), 2.5);
  EXPECT_EQ(columns.pressure().at(1, 1), 0);
  two.pressure = {-7000, -3000};
  columns.update(two);
  EXPECT_EQ(columns.pressure().at(0, 1), 0) << "suction is no pressure";
}

}  // namespace
}  // namespace sabo
