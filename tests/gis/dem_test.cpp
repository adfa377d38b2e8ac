#include <cmath>
#include <limits>

#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/read_dem.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

class ReadDem : public testing::Test {
 protected:
  Dem read(const MadeRaster& made) {
    made.write(folder_ / "dem.tif");
    return read_dem({.file = folder_ / "dem.tif"});
  }
  Fault fault(const MadeRaster& made) {
    return fault_of([&] { read(made); });
  }
  TemporaryFolder folder_;
};

TEST_F(ReadDem, KeepsValuesPlaceAndCrs) {
  const Dem dem = read({});
  const Grid expected{.columns = 3, .rows = 2, .west = 100, .north = 220, .dx = 10, .dy = 10};
  EXPECT_EQ(dem.raster.grid, expected);
  EXPECT_THAT(dem.raster.values, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(dem.crs_wkt, HasSubstr("UTM zone 54N"));
}

TEST_F(ReadDem, ReadsEsriAsciiUnderAnyName) {
  const auto file = folder_.write("dem.txt",
                                  "ncols 3\nnrows 2\nxllcorner 618049.312\nyllcorner 20\n"
                                  "cellsize 2\nNODATA_value -9999\n1 2 3\n4.5 -9999 6\n");
  const Dem dem = read_dem({.file = file, .assume_metres = true});
  EXPECT_EQ(dem.raster.grid.west, 618049.312);
  EXPECT_EQ(dem.raster.grid.north, 24);
  EXPECT_THAT(dem.raster.values, ElementsAre(1, 2, 3, 4.5, IsNan(), 6));
  EXPECT_EQ(dem.crs_wkt, "");
  const Fault fault = fault_of([&] { read_dem({.file = file}); });
  EXPECT_EQ(fault.place, "terrain.dem");
  EXPECT_THAT(fault.problem, HasSubstr("no coordinate system"));
  EXPECT_THAT(fault.remedy, HasSubstr("assume_metres"));
}

TEST_F(ReadDem, CropReadsTheCellsThatTouchTheWindow) {
  MadeRaster made{.columns = 4, .rows = 3};
  made.values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  made.write(folder_ / "dem.tif");
  // Columns start at x = 100, 110, 120, 130; rows end at y = 220, 210, 200.
  const Dem inside = read_dem({.file = folder_ / "dem.tif", .crop = {{115, 190, 125, 205}}});
  EXPECT_THAT(inside.raster.values, ElementsAre(6, 7, 10, 11));
  EXPECT_EQ(inside.raster.grid.west, 110);
  EXPECT_EQ(inside.raster.grid.north, 210);
  const Dem along_edges = read_dem({.file = folder_ / "dem.tif", .crop = {{110, 200, 130, 220}}});
  EXPECT_THAT(along_edges.raster.values, ElementsAre(2, 3, 6, 7));
  const Dem beyond = read_dem({.file = folder_ / "dem.tif", .crop = {{-1e30, -1e30, 1e30, 1e30}}});
  EXPECT_EQ(beyond.raster.values.size(), 12u);
}

TEST_F(ReadDem, RefusesAWindowBesideTheDem) {
  MadeRaster{}.write(folder_ / "dem.tif");
  for (const std::array<double, 4> crop :
       {std::array<double, 4>{0, 0, 50, 50}, {130, 200, 100, 220}, {std::nan(""), 0, 1, 1}}) {
    const Fault fault = fault_of([&] { read_dem({.file = folder_ / "dem.tif", .crop = crop}); });
    EXPECT_EQ(fault.place, "terrain.crop");
  }
}

TEST_F(ReadDem, TurnsASouthUpRaster) {
  const Dem dem = read({.geotransform = {100, 10, 0, 200, 0, 10}});
  EXPECT_EQ(dem.raster.grid.north, 220);
  EXPECT_EQ(dem.raster.grid.dy, 10);
  EXPECT_THAT(dem.raster.values, ElementsAre(4, 5, 6, 1, 2, 3));
}

TEST_F(ReadDem, MissingValuesBecomeNaN) {
  const double infinite = std::numeric_limits<double>::infinity();
  const Dem dem = read({.values = {1, -32768, std::nan(""), infinite, 5, 6}, .nodata = -32768});
  EXPECT_THAT(dem.raster.values, ElementsAre(1, IsNan(), IsNan(), IsNan(), 5, 6));
}

TEST_F(ReadDem, HonoursAMask) {
  MadeRaster{}.write(folder_ / "dem.tif");
  {
    GDALDatasetUniquePtr data(
        GDALDataset::Open((folder_ / "dem.tif").c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
    ASSERT_EQ(data->CreateMaskBand(GMF_PER_DATASET), CE_None);
    std::array<GByte, 6> mask{255, 255, 0, 255, 0, 255};
    ASSERT_EQ(data->GetRasterBand(1)->GetMaskBand()->RasterIO(GF_Write, 0, 0, 3, 2, mask.data(), 3,
                                                              2, GDT_Byte, 0, 0, nullptr),
              CE_None);
  }
  EXPECT_THAT(read_dem({.file = folder_ / "dem.tif"}).raster.values,
              ElementsAre(1, 2, IsNan(), 4, IsNan(), 6));
}

TEST_F(ReadDem, AppliesScaleAndOffset) {
  const Dem dem = read({.scale = 0.5, .offset = 100});
  EXPECT_THAT(dem.raster.values, ElementsAre(100.5, 101, 101.5, 102, 102.5, 103));
}

TEST_F(ReadDem, RefusesWhatIsNoMetricElevation) {
  EXPECT_THAT(fault({.crs = ""}).problem, HasSubstr("no coordinate system"));
  EXPECT_THAT(fault({.crs = "EPSG:4326"}).problem, HasSubstr("in degrees: EPSG:4326 (WGS 84)"));
  EXPECT_THAT(fault({.crs = "EPSG:3857"}).problem,
              HasSubstr("EPSG:3857 (WGS 84 / Pseudo-Mercator), which stretches lengths"));
  EXPECT_THAT(fault({.crs = "EPSG:2263"}).problem, HasSubstr("US survey foot, not metres"));
  EXPECT_THAT(fault({.unit = "ft"}).problem, HasSubstr("elevations in \"ft\""));
  EXPECT_THAT(fault({.bands = 3}).problem, HasSubstr("3 bands"));
  EXPECT_THAT(fault({.geotransform = {100, 10, 1, 220, 0, -10}}).problem, HasSubstr("rotated"));
  EXPECT_THAT(fault({.columns = 6, .rows = 1}).problem, HasSubstr("6 x 1 cells"));
  EXPECT_THAT(fault({.values = {-1, -1, -1, -1, -1, -1}, .nodata = -1}).problem,
              HasSubstr("no data in any cell"));
}

TEST_F(ReadDem, NamesAnUndeclaredNodataValue) {
  const Fault wrong = fault({.values = {1, 2, -32768, 4, -32768, 6}});
  EXPECT_THAT(wrong.problem, HasSubstr("2 cells of -32768 m"));
  EXPECT_THAT(wrong.remedy, HasSubstr("-a_nodata -32768"));
  EXPECT_THAT(fault({.values = {1, 2, -9999, 4, 5, 6}}).problem, HasSubstr("1 cell of -9999 m"));
}

TEST_F(ReadDem, RefusesFilesThatAreNoRasters) {
  const auto fault_in = [](const std::filesystem::path& file) {
    return fault_of([&] { read_dem({.file = file}); });
  };
  EXPECT_THAT(fault_in(folder_ / "none.tif").problem, HasSubstr("no such file"));
  EXPECT_THAT(fault_in(folder_.write("text.tif", "not a raster")).problem,
              HasSubstr("cannot be read as a raster"));
  EXPECT_THAT(fault_in(folder_ / "").problem, HasSubstr("holds no DEM tile"));
}

TEST_F(ReadDem, RefusesADamagedRaster) {
  MadeRaster made{.columns = 100, .rows = 100};
  made.values.assign(10000, 7);
  made.write(folder_ / "dem.tif");
  std::filesystem::resize_file(folder_ / "dem.tif", 20000);
  const Fault fault = fault_of([&] { read_dem({.file = folder_ / "dem.tif"}); });
  EXPECT_EQ(fault.place, "terrain.dem");
}

TEST_F(ReadDem, RefusesMoreCellsThanFitInMemory) {
  const auto file = folder_.write("huge.asc",
                                  "ncols 30000\nnrows 20000\nxllcorner 0\nyllcorner 0\n"
                                  "cellsize 1\n1 2 3\n");
  EXPECT_THAT(fault_of([&] { read_dem({.file = file, .assume_metres = true}); }).problem,
              HasSubstr("30000 x 20000 cells"));
}

TEST(ReadDemOfSharedData, ReadsRealTerrain) {
  const auto folder = data_folder() / "terrain";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  const Dem slide =
      read_dem({.file = folder / "dangchuan7_1m/dc7_dem_1411slide.txt", .assume_metres = true});
  EXPECT_EQ(slide.raster.grid.columns, 231);
  EXPECT_EQ(slide.raster.grid.rows, 261);
  EXPECT_EQ(slide.raster.grid.dx, 1);
  const Dem gully = read_dem({.file = folder / "bhutan_2m/DEM.tif"});
  EXPECT_EQ(gully.raster.grid.columns, 269);
  EXPECT_THAT(gully.crs_wkt, HasSubstr("Bhutan National Grid"));
}

}  // namespace
}  // namespace sabo
