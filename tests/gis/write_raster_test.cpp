#include "io/gis/write_raster.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/read_dem.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

Raster small_raster() {
  Raster raster(Grid{.columns = 2, .rows = 2, .west = 500000, .north = 4000000, .dx = 2, .dy = 3});
  raster.values = {0.25, Raster::no_data, 1.5, -2};
  return raster;
}

TEST(WriteRaster, ComesBackAsWritten) {
  const TemporaryFolder folder;
  const RasterInfo info{wkt_of_code("EPSG:32654"), "final deposit", "m", {{"TIME", "120 s"}}};
  write_raster(folder / "dep.tif", small_raster(), info);
  const Dem dem = read_dem({.file = folder / "dep.tif"});
  EXPECT_EQ(dem.raster.grid, small_raster().grid);
  EXPECT_THAT(dem.raster.values, ElementsAre(0.25, IsNan(), 1.5, -2));
  EXPECT_THAT(dem.crs_wkt, HasSubstr("32654"));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WriteRaster, SaysWhatItHolds) {
  const TemporaryFolder folder;
  write_raster(folder / "dep.tif", small_raster(), {"", "final deposit", "m", {{"TIME", "120 s"}}});
  GDALDatasetUniquePtr data(GDALDataset::Open((folder / "dep.tif").c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(data);
  GDALRasterBand& band = *data->GetRasterBand(1);
  EXPECT_EQ(band.GetRasterDataType(), GDT_Float32);
  EXPECT_EQ(band.GetNoDataValue(), -9999);
  EXPECT_STREQ(band.GetDescription(), "final deposit");
  EXPECT_STREQ(band.GetUnitType(), "m");
  EXPECT_STREQ(data->GetMetadataItem("TIME"), "120 s");
  EXPECT_STREQ(data->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");
}

TEST(WriteRaster, RefusesAnInfiniteValue) {
  const TemporaryFolder folder;
  Raster raster = small_raster();
  raster.at(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(run_error_of([&] { write_raster(folder / "dep.tif", raster, {}); }),
              HasSubstr("column 1, row 1"));
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(WriteRaster, ReportsAFailedWriteAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  write_raster(folder / "dep.tif", small_raster(), {});
  const std::string before = folder.read("dep.tif");
  Raster large(Grid{.columns = 300, .rows = 300});
  std::mt19937 random(1);
  for (double& value : large.values) value = std::uniform_real_distribution<>()(random);
  {
    const FullDisk full(16384);
    EXPECT_THAT(run_error_of([&] { write_raster(folder / "dep.tif", large, {}); }),
                HasSubstr("cannot write " + (folder / "dep.tif").string()));
  }
  EXPECT_EQ(folder.read("dep.tif"), before);
  EXPECT_EQ(folder.file_count(), 1u);
  EXPECT_THAT(run_error_of([&] { write_raster(folder / "no/dep.tif", large, {}); }),
              HasSubstr("No such file or directory"));
}

}  // namespace
}  // namespace sabo
