#include "io/gis/class_map.hpp"

#include <cmath>

#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/file_kind.hpp"
#include "io/gis/raster_file.hpp"
#include "io/gis/read_vectors.hpp"
#include "io/gis/write_ascii_grid.hpp"
#include "io/gis/write_layers.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

constexpr double none = Raster::no_data;

/// A ring of 2 around a 1, and a 3 that touches it at a corner; cells of 2 x 3 m.
Raster ring() {
  Raster raster({4, 4, 500, 300, 2, 3});
  raster.values = {2,    2,    2,    none,  //
                   2,    1,    2,    none,  //
                   2,    2,    2,    none,  //
                   none, none, none, 3};
  return raster;
}

TEST(ClassMap, OutlinesFollowTheCells) {
  const std::vector<ClassPolygon> polygons = polygons_of(ring());
  ASSERT_EQ(polygons.size(), 3u);
  double total = 0;
  for (const ClassPolygon& one : polygons) {
    total += area(one.polygon);
    if (one.number != 2) continue;
    EXPECT_EQ(one.polygon.rings.size(), 2u) << "a hole";
    EXPECT_DOUBLE_EQ(area(one.polygon), 8 * 6);
    EXPECT_TRUE(contains(one.polygon, 501, 298));
    EXPECT_FALSE(contains(one.polygon, 503, 295.5));
  }
  EXPECT_DOUBLE_EQ(total, 10 * 6);
  EXPECT_TRUE(polygons_of(Raster({3, 3, 0, 3, 1, 1}, none)).empty());
}

TEST(ClassMap, ClassesKeepNumbersColoursAndNames) {
  const TemporaryFolder folder;
  const auto file = folder / "classes.tif";
  write_class_raster(file, ring(), {{1, "weak", {1, 2, 3}}, {2, "strong & fast", {200, 10, 0}}},
                     wkt_of_code("EPSG:32654"), "what");
  const Raster back = RasterFile(file, "map").read();
  EXPECT_EQ(back.grid, ring().grid);
  for (std::size_t cell = 0; cell < back.values.size(); ++cell) {
    const double value = ring().values[cell];
    if (std::isnan(value)) {
      EXPECT_TRUE(std::isnan(back.values[cell]));
    } else {
      EXPECT_EQ(back.values[cell], value);
    }
  }
  GDALDatasetUniquePtr data(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(data);
  GDALRasterBand& band = *data->GetRasterBand(1);
  ASSERT_TRUE(band.GetColorTable());
  EXPECT_EQ(band.GetColorTable()->GetColorEntry(2)->c1, 200);
  char** names = band.GetCategoryNames();
  ASSERT_TRUE(names);
  EXPECT_STREQ(names[2], "strong & fast");
  EXPECT_STREQ(data->GetMetadataItem("CLASS_1"), "weak");
  EXPECT_EQ(folder.file_count(), 2u) << "the raster and its names";
}

// Where a user has switched side files off, the names of classes are left out.
TEST(ClassMap, IsWrittenWithoutSideFilesToo) {
  const TemporaryFolder folder;
  const CPLConfigOptionSetter no_side_files("GDAL_PAM_ENABLED", "NO", false);
  write_class_raster(folder / "classes.tif", ring(), {{1, "weak", {1, 2, 3}}}, "", "what");
  EXPECT_EQ(folder.file_count(), 1u);
  EXPECT_EQ(RasterFile(folder / "classes.tif", "map").read().grid, ring().grid);
}

TEST(ClassMap, RefusesWhatIsNoNumberOfAClass) {
  const TemporaryFolder folder;
  for (const double wrong : {0.0, 1.5, 256.0, -1.0}) {
    Raster raster = ring();
    raster.values[0] = wrong;
    EXPECT_THAT(run_error_of([&] { polygons_of(raster); }), HasSubstr("is not the number"));
    EXPECT_THAT(run_error_of([&] { write_class_raster(folder / "a.tif", raster, {}, "", ""); }),
                HasSubstr("is not the number"));
  }
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(AsciiGrid, GivesEveryValueBack) {
  const TemporaryFolder folder;
  for (const double dy : {2.0, 3.0}) {
    Raster raster({3, 2, 350000.25, 3129000.5, 2, dy});
    raster.values = {0.1f, 1.0f / 3, none, 12345.678f, -2.5e-7f, 0};
    const auto file = folder / "map.asc";
    write_ascii_grid(file, raster, wkt_of_code("EPSG:6688"));
    const RasterFile back(file, "map");
    EXPECT_EQ(back.grid(), raster.grid);
    EXPECT_EQ(back.crs().IsProjected(), 1);
    const Raster read = back.read();
    for (std::size_t cell = 0; cell < read.values.size(); ++cell) {
      if (std::isnan(raster.values[cell])) {
        EXPECT_TRUE(std::isnan(read.values[cell]));
      } else {
        EXPECT_EQ(static_cast<float>(read.values[cell]), static_cast<float>(raster.values[cell]));
      }
    }
    EXPECT_EQ(folder.file_count(), 2u) << ".asc and .prj";
  }
}

TEST(VectorLayers, AreReadBack) {
  const TemporaryFolder folder;
  const auto file = folder / "plan.gpkg";
  const Polygon square{
      {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}}}};
  const VectorLayer areas{"areas", {{"name", false}, {"depth", true}}, {{square, {"a", 0.5}}}};
  const VectorLayer lines{
      "lines", {{"name", false}}, {{Polyline{{{0, 0, 0}, {3, 4, 0}}}, {"O'Brien \"; DROP"}}}};
  write_layers(file, {areas, lines, {"empty", {}, {}}}, wkt_of_code("EPSG:32654"));
  const auto polygons = read_valued_polygons(file, wkt_of_code("EPSG:32654"), "key", "depth");
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].value, 0.5);
  EXPECT_DOUBLE_EQ(area(polygons[0].polygon), 15);
  const auto read = read_lines(file, wkt_of_code("EPSG:32654"), "key");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(length(read[0]), 5);
  EXPECT_EQ(kind_of_gis_file(file), GisFileKind::vectors);
  EXPECT_EQ(kind_of_gis_file(folder / "none.tif"), GisFileKind::unknown);
  EXPECT_THAT(run_error_of([&] {
                write_layers(file, {{"empty", {}, {}}}, "");
              }),
              HasSubstr("would hold nothing"));
}

}  // namespace
}  // namespace sabo
