#include <cmath>

#include "rasters.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "terrain/hole_filling.hpp"

namespace sabo {
namespace {

Raster tilted() {
  return raster_of({12, 10, 0, 20, 1, 2}, [](double x, double y) { return 3 * x - 2 * y; });
}

TEST(FillHoles, RestoresAPlane) {
  Raster raster = tilted();
  for (int row = 2; row < 6; ++row) {
    for (int column = 3; column < 8; ++column) raster.at(column, row) = Raster::no_data;
  }
  const HoleReport report = fill_holes(raster, 20);
  EXPECT_EQ(report.holes_filled, 1);
  EXPECT_EQ(report.cells_filled, 20U);
  const Raster expected = tilted();
  for (std::size_t k = 0; k < raster.values.size(); ++k) {
    EXPECT_NEAR(raster.values[k], expected.values[k], 1e-4);
  }
}

TEST(FillHoles, LeavesLargeAndOuterAreas) {
  Raster raster = tilted();
  raster.at(0, 4) = raster.at(1, 4) = Raster::no_data;  // at the border
  raster.at(2, 5) = Raster::no_data;                    // linked by a corner
  raster.at(5, 5) = Raster::no_data;                    // a hole of one cell
  for (int column = 5; column < 9; ++column) raster.at(column, 2) = Raster::no_data;  // too large
  const HoleReport report = fill_holes(raster, 3);
  EXPECT_EQ(report.holes_filled, 1);
  EXPECT_EQ(report.cells_filled, 1U);
  EXPECT_EQ(report.holes_left, 1);
  EXPECT_EQ(report.enclosed_cells_left, 4U);
  EXPECT_EQ(report.border_cells_left, 3U);
  EXPECT_NEAR(raster.at(5, 5), tilted().at(5, 5), 1e-6);
  EXPECT_TRUE(std::isnan(raster.at(2, 5)));
  EXPECT_TRUE(std::isnan(raster.at(6, 2)));
}

TEST(FillHoles, StaysWithinTheRim) {
  Random random;
  Raster raster = raster_of(square_grid(0, 40, 1), [&](double, double) { return random(); });
  for (int row = 5; row < 35; ++row) {
    for (int column = 5; column < 35; ++column) raster.at(column, row) = Raster::no_data;
  }
  EXPECT_EQ(fill_holes(raster, 900).cells_filled, 900U);
  for (const double value : raster.values) {
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1);
  }
}

TEST(FillHoles, LeavesAnEmptyRasterAlone) {
  Raster raster({4, 4, 0, 0, 1, 1}, Raster::no_data);
  EXPECT_EQ(fill_holes(raster, 100).border_cells_left, 16U);
}

}  // namespace
}  // namespace sabo
