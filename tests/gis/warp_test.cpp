#include "io/gis/warp.hpp"

#include <cmath>
#include <memory>

#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/target_crs.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

const OGRSpatialReference no_crs;

Raster resized(const Raster& raster, double cell_size) {
  return warp(raster, no_crs, plan_warp(raster.grid, no_crs, no_crs, cell_size), no_crs);
}

Raster square(std::vector<double> values) {
  Raster raster(Grid{.columns = 4, .rows = 4, .west = 500, .north = 800, .dx = 10, .dy = 10});
  raster.values = std::move(values);
  return raster;
}

double plane(double x, double y) { return 0.5 * x - 0.3 * y + 100; }

// Largest difference from the plane over the cells at least `rim` away from the edges.
double largest_error(const Raster& raster, double rim) {
  const Grid& grid = raster.grid;
  double largest = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double x = grid.x_of(column);
      const double y = grid.y_of(row);
      const bool is_inner = x > grid.west + rim && x < grid.east() - rim &&
                            y > grid.south() + rim && y < grid.north - rim;
      if (is_inner) largest = std::max(largest, std::abs(raster.at(column, row) - plane(x, y)));
    }
  }
  return largest;
}

Raster tilted_plane() {
  Raster raster(Grid{.columns = 40, .rows = 30, .west = 500, .north = 800, .dx = 10, .dy = 10});
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column)
      raster.at(column, row) = plane(raster.grid.x_of(column), raster.grid.y_of(row));
  return raster;
}

TEST(Warp, CoarserCellsAreMeans) {
  const Raster mean = resized(square({1, 2, 10, 10,  //
                                      3, 4, 10, 10,  //
                                      0, 0, -1, 1,   //
                                      0, 8, 5, 3}),
                              20);
  EXPECT_EQ(mean.grid.west, 500);
  EXPECT_EQ(mean.grid.north, 800);
  EXPECT_THAT(mean.values, ElementsAre(2.5, 10, 2, 2));
}

TEST(Warp, MissingCellsTakeNoPartInAMean) {
  const double no = Raster::no_data;
  EXPECT_THAT(resized(square({1, no, no, no,    //
                              no, 4, no, no,    //
                              -9999, 1, 5, no,  //
                              1, 1, no, no}),
                      20)
                  .values,
              ElementsAre(2.5, IsNan(), -2499, 5));
}

TEST(Warp, FinerCellsAreBilinear) {
  // A quarter of a cell from the centres of two cells: 3/4 of the near, 1/4 of the far.
  Raster raster(Grid{.columns = 4, .rows = 2, .west = 0, .north = 20, .dx = 10, .dy = 10});
  raster.values = {0, 0, 8, 8, 0, 0, 8, 8};
  const Raster fine = resized(raster, 5);
  ASSERT_EQ(fine.values.size(), 32u);
  for (int row = 0; row < 4; ++row) {
    const auto begin = fine.values.begin() + 8 * row;
    EXPECT_THAT(std::vector(begin, begin + 8), ElementsAre(0, 0, 0, 2, 6, 8, 8, 8));
  }
}

TEST(Warp, MissingCellsStayMissingAndTheirNeighboursInRange) {
  Raster raster = tilted_plane();
  for (double& value : raster.values) value = 7;
  for (int row = 10; row < 20; ++row)
    for (int column = 10; column < 20; ++column) raster.at(column, row) = Raster::no_data;
  const Raster fine = resized(raster, 2.5);
  for (int row = 0; row < fine.grid.rows; ++row) {
    for (int column = 0; column < fine.grid.columns; ++column) {
      const double below = raster.at(column / 4, row / 4);
      const double value = fine.at(column, row);
      EXPECT_TRUE(std::isnan(below) ? std::isnan(value) : std::abs(value - 7) < 1e-12)
          << column << " " << row << ": " << value;
    }
  }
}

TEST(Warp, APlaneStaysThePlane) {
  constexpr double rounding = 1e-9;
  EXPECT_LT(largest_error(resized(tilted_plane(), 4), 5), rounding);
  EXPECT_LT(largest_error(resized(tilted_plane(), 10 / 3.0), 5), rounding);
  EXPECT_LT(largest_error(resized(tilted_plane(), 30), 30), rounding);
}

TEST(Warp, ThePlaneOfAMapStaysThePlaneFromDegrees) {
  // 45 N: cells of 0.2 seconds are 4.38 x 6.17 m, so some are made narrower and some wider.
  const OGRSpatialReference degrees = crs_of_code(6668);
  const OGRSpatialReference utm = crs_of_code(6691);
  Grid grid{.columns = 300, .rows = 200, .west = 142.2, .north = 45};
  grid.dx = grid.dy = 0.2 / 3600;
  Raster raster(grid);
  const std::unique_ptr<OGRCoordinateTransformation> to_map(
      OGRCreateCoordinateTransformation(&degrees, &utm));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      double x = grid.x_of(column);
      double y = grid.y_of(row);
      ASSERT_TRUE(to_map->Transform(1, &x, &y));
      raster.at(column, row) = plane(x, y);
    }
  }
  const WarpPlan plan = plan_warp(grid, degrees, utm, 5);
  EXPECT_EQ(std::fmod(plan.grid.west, 5), 0);
  EXPECT_EQ(std::fmod(plan.grid.north, 5), 0);
  EXPECT_FALSE(plan.averages);
  // Places may be off by 0.001 cells of 5 m, on a slope of 0.58 that is 0.003 m. The rim is that of
  // the tilted map: 1200 m of height at 0.85 degrees of meridian convergence, and a cell.
  EXPECT_LT(largest_error(warp(raster, degrees, plan, utm), 35), 0.003);
}

TEST(Warp, TakesAboutTheCellsOfTheSource) {
  const OGRSpatialReference degrees = crs_of_code(4326);
  const OGRSpatialReference utm = crs_of_code(32654);
  const OGRSpatialReference zone_8 = crs_of_code(6676);
  Grid second{.columns = 10, .rows = 10, .west = 138, .north = 36};
  second.dx = second.dy = 1.0 / 3600;  // 25 x 31 m
  EXPECT_DOUBLE_EQ(plan_warp(second, degrees, utm, 0).grid.dx, 30);
  const Grid metres{.columns = 100, .rows = 100, .west = 5e5, .north = 4e6, .dx = 2.5, .dy = 2.5};
  EXPECT_EQ(plan_warp(metres, utm, zone_8, 0).grid.dx, 2.5);
}

TEST(Warp, RefusesWhatCannotBe) {
  const Grid grid{.columns = 10, .rows = 10, .west = 5e5, .north = 4e6, .dx = 10, .dy = 10};
  const auto fault = [&](const OGRSpatialReference& from, const OGRSpatialReference& to,
                         double size) {
    return fault_of([&] { plan_warp(grid, from, to, size); });
  };
  const OGRSpatialReference utm = crs_of_code(6691);
  EXPECT_EQ(fault(utm, utm, 100).place, "terrain.cell_size");
  EXPECT_THAT(fault(utm, utm, 1e-9).remedy, HasSubstr("larger cells"));
  const Fault metres_as_degrees = fault(crs_of_code(6668), utm, 5);
  EXPECT_EQ(metres_as_degrees.place, "terrain.crs");
  EXPECT_THAT(metres_as_degrees.problem, HasSubstr("EPSG:6668 (JGD2011) to EPSG:6691"));
}

}  // namespace
}  // namespace sabo
