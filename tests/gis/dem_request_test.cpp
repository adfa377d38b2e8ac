#include <cmath>

#include "gis/made_fg_gml.hpp"
#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/read_dem.hpp"

namespace sabo {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

class DemRequests : public testing::Test {
 protected:
  // A plane of 40 x 30 cells of 10 m that rises to the east, UTM 54N.
  MadeRaster plane_in_metres() const {
    MadeRaster made{.columns = 40, .rows = 30, .values = {}};
    made.geotransform = {500000, 10, 0, 4000000, 0, -10};
    for (int k = 0; k < 1200; ++k) made.values.push_back(5 + 10 * (k % 40));
    return made;
  }
  Dem read(const MadeRaster& made, DemRequest request) {
    request.file = folder_ / "dem.tif";
    made.write(request.file);
    return read_dem(request);
  }
  Fault crs_fault(const std::string& crs) {
    const Fault fault = fault_of([&] { read(plane_in_metres(), {.crs = crs}); });
    EXPECT_EQ(fault.place, "terrain.crs");
    EXPECT_THAT(fault.remedy, HasSubstr("EPSG:"));
    return fault;
  }
  TemporaryFolder folder_;
};

TEST_F(DemRequests, ACellSizeResamplesFromTheNorthWestCorner) {
  const Dem dem = read(plane_in_metres(), {.cell_size = 20});
  const Grid expected{
      .columns = 20, .rows = 15, .west = 500000, .north = 4000000, .dx = 20, .dy = 20};
  EXPECT_EQ(dem.raster.grid, expected);
  EXPECT_EQ(dem.raster.at(0, 0), 10);  // the mean of 5 and 15
  EXPECT_THAT(dem.notes, ElementsAre("resampled from cells of 10 x 10 m to 20 m, mean of the cells "
                                     "below"));
  EXPECT_THAT(dem.crs_wkt, HasSubstr("UTM zone 54N"));
}

TEST_F(DemRequests, ACropOfTheResultIsAPartOfTheWhole) {
  const Dem whole = read(plane_in_metres(), {.cell_size = 4});
  const Dem part =
      read(plane_in_metres(), {.crop = {{500101, 3999801, 500149, 3999849}}, .cell_size = 4});
  EXPECT_EQ(part.raster.grid.west, 500100);
  EXPECT_EQ(part.raster.grid.north, 3999852);
  EXPECT_EQ(part.raster.grid.columns, 13);
  constexpr double rounding = 1e-9;  // of a coordinate of 4e6 m
  for (int row = 0; row < part.raster.grid.rows; ++row)
    for (int column = 0; column < 13; ++column)
      EXPECT_NEAR(part.raster.at(column, row), whole.raster.at(column + 25, row + 37), rounding);
}

TEST_F(DemRequests, NothingIsDoneWhenNothingIsAsked) {
  const Dem dem = read(plane_in_metres(), {.crs = "EPSG:32654", .cell_size = 10});
  EXPECT_EQ(dem.raster.values, plane_in_metres().values);
  EXPECT_TRUE(dem.notes.empty());
}

TEST_F(DemRequests, DegreesNeedACoordinateSystem) {
  MadeRaster made{.columns = 40, .rows = 30, .values = std::vector<double>(1200, 7)};
  made.geotransform = {141, 1.0 / 3600, 0, 36, 0, -1.0 / 3600};
  made.crs = "EPSG:6668";
  const Fault fault = fault_of([&] { read(made, {}); });
  EXPECT_EQ(fault.place, "terrain.dem");
  EXPECT_THAT(fault.remedy, HasSubstr("set terrain.crs"));
  const Dem dem = read(made, {.crs = "EPSG:6677"});  // plane zone IX, whose x is north
  EXPECT_EQ(dem.raster.grid.dx, 30);
  // Its origin is 36 N, 139 deg 50 min E; on the parallel of 36 N, 1 deg 10 min are 105.2 km.
  EXPECT_NEAR(dem.raster.grid.west, 105200, 100);
  EXPECT_THAT(dem.notes,
              ElementsAre(HasSubstr("reprojected from EPSG:6668 (JGD2011) to EPSG:6677 (")));
  EXPECT_THAT(dem.raster.values, Contains(7));
}

TEST_F(DemRequests, RefusesACoordinateSystemThatIsNoMapInMetres) {
  EXPECT_THAT(crs_fault("EPSG:99999999").problem, HasSubstr("\"EPSG:99999999\" is no coordinate"));
  EXPECT_THAT(crs_fault("Japan").problem, HasSubstr("\"Japan\" is no coordinate system"));
  EXPECT_THAT(crs_fault("EPSG:6668").problem, HasSubstr("EPSG:6668 (JGD2011) is in degrees"));
  EXPECT_THAT(crs_fault("EPSG:4978").problem, HasSubstr("not a projected coordinate system"));
  EXPECT_THAT(crs_fault("EPSG:2263").problem, HasSubstr("US survey foot, not metres"));
  EXPECT_THAT(crs_fault("EPSG:6691+8228").problem, HasSubstr("elevations in units of foot"));
  folder_.write("utm.prj", wkt_of_code("EPSG:6691"));
  EXPECT_THAT(crs_fault((folder_ / "utm.prj").string()).problem, HasSubstr("no coordinate"));
}

TEST_F(DemRequests, RefusesCellSizesThatAreNone) {
  for (const double size : {-1.0, std::nan(""), 1e-4, 1000.0}) {
    const Fault fault = fault_of([&] { read(plane_in_metres(), {.cell_size = size}); });
    EXPECT_EQ(fault.place, "terrain.cell_size") << size;
  }
}

TEST_F(DemRequests, ARasterWithoutOneIsTakenToBeInTheGivenCoordinateSystem) {
  MadeRaster made = plane_in_metres();
  made.crs = "";
  const Dem dem = read(made, {.crs = "EPSG:6691"});
  EXPECT_EQ(dem.raster.values, made.values);
  EXPECT_THAT(dem.crs_wkt, HasSubstr("JGD2011 / UTM zone 54N"));
  EXPECT_THAT(dem.notes, ElementsAre(HasSubstr("taken to be in EPSG:6691")));
}

TEST_F(DemRequests, AnAsciiGridHasTheCoordinateSystemOfItsPrj) {
  const auto file = folder_.write("dem.asc",
                                  "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 20\n"
                                  "cellsize 2\n1 2 3\n4.5 5 6\n");
  folder_.write("dem.prj", wkt_of_code("EPSG:6691"));
  EXPECT_THAT(read_dem({.file = file}).crs_wkt, HasSubstr("JGD2011 / UTM zone 54N"));
}

TEST_F(DemRequests, TilesGoToTheUtmZoneOfTheirMiddle) {
  // 45 N on the central meridian of zone 54, 141 E, is 0.9996 times the meridian arc of GRS 80 from
  // the equator, 4984944.378 m. The corner of four blocks of cells lies there.
  std::string tuples;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column)
      tuples += fmt::format("地表面,{}\n", (row < 10 ? 100 : 300) + (column < 10 ? 0 : 100));
  const MadeFgGml made{.tuples = tuples,
                       .south_cells = 10,
                       .west_cells = -10,
                       .high = "19 19",
                       .columns = 20,
                       .rows = 20};
  const Dem dem = read_dem({.file = folder_.write("tile.xml", made.text())});
  const Grid& grid = dem.raster.grid;
  EXPECT_EQ(grid.dx, 5);
  EXPECT_THAT(dem.crs_wkt, HasSubstr("JGD2011 / UTM zone 54N"));
  const double x = 500000;
  const double y = 0.9996 * 4984944.378;
  // Further than a cell of the tile from the edges of the blocks, they have their own values.
  const auto at = [&](double dx, double dy) {
    return dem.raster.at(grid.column_of(x + dx), grid.row_of(y + dy));
  };
  EXPECT_NEAR(at(-10, 10), 100, 1e-9);
  EXPECT_NEAR(at(10, 10), 200, 1e-9);
  EXPECT_NEAR(at(-10, -10), 300, 1e-9);
  EXPECT_NEAR(at(10, -10), 400, 1e-9);
  // Across the middle the step of 100 m has its half where the meridian is, to a quarter cell: the
  // bilinear ramp is 4.38 m wide.
  const double west_of = dem.raster.at(grid.column_of(x - 2.5), grid.row_of(y + 10));
  const double east_of = dem.raster.at(grid.column_of(x + 2.5), grid.row_of(y + 10));
  EXPECT_NEAR((west_of + east_of) / 2, 150, 1);
  EXPECT_THAT(dem.notes, ElementsAre("1 tile of 5 m, JGD2011, date 2016-10-01",
                                     "reprojected from EPSG:6668 (JGD2011) to EPSG:6691 (JGD2011 / "
                                     "UTM zone 54N), cells of 5 m, bilinear"));
}

TEST_F(DemRequests, OldTilesStayInTheirDatumAndCellsMayBeChosen) {
  std::string tuples;
  for (int k = 0; k < 400; ++k) tuples += "地表面,12.5\n";
  const MadeFgGml made{.tuples = tuples,
                       .south_cells = 20,
                       .seconds = 0.4,
                       .srs = "fguuid:jgd2000.bl",
                       .high = "19 19",
                       .columns = 20,
                       .rows = 20};
  const auto file = folder_.write("tile.xml", made.text());
  const Dem dem = read_dem({.file = file});
  EXPECT_THAT(dem.crs_wkt, HasSubstr("JGD2000 / UTM zone 54N"));
  EXPECT_EQ(dem.raster.grid.dx, 10);
  const Dem coarse = read_dem({.file = file, .crs = "EPSG:2454", .cell_size = 50});
  EXPECT_EQ(coarse.raster.grid.dx, 50);
  EXPECT_THAT(coarse.raster.values,
              testing::Each(testing::AnyOf(testing::DoubleEq(12.5), IsNan())));
  EXPECT_THAT(coarse.notes, Contains(HasSubstr("cells of 50 m, mean of the cells below")));
}

}  // namespace
}  // namespace sabo
