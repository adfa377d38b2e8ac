#include "post/export_run.hpp"

#include <fstream>

#include "post/made_run.hpp"
#include "support/fault_of.hpp"
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "io/gis/raster_file.hpp"
#include "io/gis/read_vectors.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

class ExportRun : public testing::Test {
 protected:
  ExportRun() {
    MadeRun run;
    run.crs = wkt_of_test_crs();
    run.depth = [](double x, double y) {
      return std::max(0.0, 0.9 - 0.004 * ((x - 15) * (x - 15) + (y - 10) * (y - 10)));
    };
    run.write(folder_ / "run");
  }
  double volume_of(const std::filesystem::path& file) const {
    const Raster raster = RasterFile(file, "map").read();
    double sum = 0;
    for (const double value : raster.values)
      if (!std::isnan(value)) sum += value * raster.grid.cell_area();
    return sum;
  }
  TemporaryFolder folder_;
};

TEST_F(ExportRun, EveryMapIsThereWithItsVolumeAndItsStyle) {
  export_run({folder_ / "run", folder_ / "out", {}, {0.1, 0.5, 1, 2}});
  const double volume = volume_of(folder_ / "run/maps/dep.tif");
  ASSERT_GT(volume, 100);
  EXPECT_NEAR(volume_of(folder_ / "out/ascii/dep.asc"), volume, 1e-6 * volume);
  EXPECT_NEAR(volume_of(folder_ / "out/maps/dep.tif"), volume, 1e-9 * volume);
  for (const char* name : {"dep", "pfd", "pfv", "tarr", "ground"}) {
    const std::string file = name;
    EXPECT_TRUE(std::filesystem::exists(folder_ / ("out/ascii/" + file + ".asc"))) << name;
    EXPECT_TRUE(std::filesystem::exists(folder_ / ("out/ascii/" + file + ".prj"))) << name;
    std::ostringstream style;
    style << std::ifstream(folder_ / ("out/maps/" + file + ".qml")).rdbuf();
    EXPECT_THAT(style.str(), HasSubstr("<rasterrenderer type=")) << name;
    const RasterFile map(folder_ / ("out/maps/" + file + ".tif"), "map");
    EXPECT_FALSE(map.unit().empty()) << name;
  }
}

TEST_F(ExportRun, OutlinesHoldTheCellsDeeperThanTheirDepth) {
  export_run({folder_ / "run", folder_ / "out", {"gpkg"}, {0.5, 1}});
  GDALDatasetUniquePtr data(
      GDALDataset::Open((folder_ / "out/vectors.gpkg").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(data);
  OGRLayer* layer = data->GetLayerByName("affected_area");
  ASSERT_TRUE(layer);
  const Raster peak = RasterFile(folder_ / "run/maps/pfd.tif", "map").read();
  for (const double depth : {0.5, 1.0}) {
    double cells = 0;
    for (const double value : peak.values) cells += value > depth ? 1 : 0;
    double sum = 0;
    layer->ResetReading();
    for (const auto& feature : *layer)
      if (feature->GetFieldAsDouble("deeper_than_m") == depth)
        sum += feature->GetFieldAsDouble("area_m2");
    ASSERT_GT(cells, 0);
    EXPECT_DOUBLE_EQ(sum, cells * 4) << depth;
  }
  for (const char* name : {"path", "zones", "deposit_area"})
    EXPECT_TRUE(data->GetLayerByName(name)) << name;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/ascii"));
}

TEST_F(ExportRun, StructuresAreWholeAndHaveTheirNames) {
  MadeRun run;
  run.depth = slab(10, 20, 5, 15);
  run.keys =
      "[[structure]]\nname = \"slit\"\nline = [[30, 2], [30, 18]]\nthickness = 2\nheight = 8\n"
      "[[structure.slit]]\ncentre = 8\nwidth = 4\n"
      "[[body]]\nname = \"house\"\nkind = \"box\"\nmin = [34, 8, 0]\nmax = [38, 12, 60]\n";
  run.write(folder_ / "built");
  export_run({folder_ / "built", folder_ / "out", {"gpkg"}, {0.5}});
  GDALDatasetUniquePtr data(
      GDALDataset::Open((folder_ / "out/vectors.gpkg").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(data);
  OGRLayer* layer = data->GetLayerByName("structures");
  ASSERT_TRUE(layer);
  std::vector<std::string> names;
  for (const auto& feature : *layer) names.push_back(feature->GetFieldAsString("name"));
  EXPECT_THAT(names, testing::ElementsAre("slit", "house"));
}

/// Of another run, or made with other formats.
TEST_F(ExportRun, LeavesNothingOfAFormerExport) {
  export_run({folder_ / "run", folder_ / "out", {}, {0.5}});
  ASSERT_TRUE(std::filesystem::exists(folder_ / "out/vectors.gpkg"));
  export_run({folder_ / "run", folder_ / "out", {"qgis"}, {0.5}});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/vectors.gpkg"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/ascii"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/maps/dep.tif"));
}

TEST_F(ExportRun, RefusesUnknownFormatsAndDepths) {
  EXPECT_THAT(fault_of([&] {
                export_run({folder_ / "run", "", {"shp"}, {}});
              }).problem,
              HasSubstr("\"shp\" is not known"));
  EXPECT_THAT(fault_of([&] {
                export_run({folder_ / "run", "", {}, {-1}});
              }).problem,
              HasSubstr("is not a depth"));
}

TEST_F(ExportRun, WithoutItsCaseTheMapsAreStillWritten) {
  std::ofstream(folder_ / "run/case.toml") << "[terrain]\ndem = \"gone.tif\"\n";
  const auto lines = export_run({folder_ / "run", folder_ / "out", {"gpkg"}, {0.5}});
  EXPECT_THAT(lines,
              testing::Contains(HasSubstr("structures, inflows, sections, path and zones are left "
                                          "out: case.toml:2 terrain.dem: there is no file")));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/vectors.gpkg"));
}

}  // namespace
}  // namespace sabo
