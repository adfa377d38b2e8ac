#include <sstream>

#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "io/gis/read_vectors.hpp"
#include "io/gis/write_vectors.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Vectors : public testing::Test {
 protected:
  // A GeoJSON file of these geometries, one a line; `crs` may be "" as the format has it today.
  std::filesystem::path geojson(const std::string& geometries, const std::string& crs = "") {
    std::ostringstream text;
    text << R"({"type": "FeatureCollection", )";
    if (!crs.empty()) {
      text << R"("crs": {"type": "name", "properties": {"name": ")" << crs << R"("}}, )";
    }
    text << R"("features": [)";
    std::istringstream lines(geometries);
    std::string geometry;
    for (bool is_first = true; std::getline(lines, geometry); is_first = false) {
      text << (is_first ? "" : ",") << R"({"type": "Feature", "properties": {}, "geometry": )"
           << geometry << "}";
    }
    text << "]}";
    return folder_.write("v.geojson", text.str());
  }
  Fault line_fault(const std::filesystem::path& file) {
    return fault_of([&] { read_lines(file, utm54_, "path.line"); });
  }
  Fault polygon_fault(const std::filesystem::path& file) {
    return fault_of([&] { read_polygons(file, utm54_, "release.polygon"); });
  }
  TemporaryFolder folder_;
  const std::string utm54_ = wkt_of_code("EPSG:32654");
  const std::string utm54_name_ = "urn:ogc:def:crs:EPSG::32654";
};

TEST_F(Vectors, LinesGoThroughAGeoPackageUnchanged) {
  const NamedLine dam{"dam 1", {{{500000.25, 4000000.5, 31}, {500010, 4000020, 32}}, true}};
  write_lines(folder_ / "dam.gpkg", {dam}, utm54_);
  const auto lines = read_lines(folder_ / "dam.gpkg", utm54_, "structure[0].line");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].has_z);
  EXPECT_EQ(lines[0].vertices, dam.line.vertices);
  EXPECT_EQ(folder_.file_count(), 1u);
}

TEST_F(Vectors, PolygonsGoThroughAGeoPackageWithoutTheirClosingVertices) {
  const Polygon square{
      {{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}}}};
  write_polygons(folder_ / "release.gpkg", {{"source", square}}, "");
  const auto polygons = read_polygons(folder_ / "release.gpkg", utm54_, "release.polygon");
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].rings, square.rings);
}

TEST_F(Vectors, ReprojectsWithEastFirst) {
  // Central meridian of zone 54 is 141 E: easting 500000 exactly, northing 0 on the equator.
  const auto file = geojson(R"({"type": "LineString", "coordinates": [[141, 0], [141, 1]]})");
  const auto lines = read_lines(file, utm54_, "path.line");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].has_z);
  EXPECT_NEAR(lines[0].vertices[0].x, 500000, 1e-6);
  EXPECT_NEAR(lines[0].vertices[0].y, 0, 1e-6);
  // 0.9996 x the meridian arc of the first degree on WGS 84, 110574.389 m.
  EXPECT_NEAR(lines[0].vertices[1].y, 0.9996 * 110574.389, 0.01);
}

TEST_F(Vectors, SplitsCollectionsAndLeavesOtherGeometriesOut) {
  const auto file = geojson(
      R"({"type": "Point", "coordinates": [5, 5]}
{"type": "MultiLineString", "coordinates": [[[0, 0], [1, 0], [1, 0]], [[2, 0], [3, 0]]]}
{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]]]}
{"type": "LineString", "coordinates": [[7, 7], [8, 8]]})",
      utm54_name_);
  const auto lines = read_lines(file, utm54_, "path.line");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_THAT(lines[0].vertices, ElementsAre(Vec3d{0, 0, 0}, Vec3d{1, 0, 0}));
  EXPECT_THAT(lines[2].vertices, ElementsAre(Vec3d{7, 7, 0}, Vec3d{8, 8, 0}));
  EXPECT_EQ(read_polygons(file, utm54_, "release.polygon").size(), 1u);
  EXPECT_THAT(read_points(file, utm54_, "gauge[1].file"), ElementsAre(Vec3d{5, 5, 0}));
}

TEST_F(Vectors, SaysWhatIsMissing) {
  const auto file =
      geojson(R"({"type": "LineString", "coordinates": [[0, 0], [1, 0]]})", utm54_name_);
  const Fault missing = polygon_fault(file);
  EXPECT_EQ(missing.place, "release.polygon");
  EXPECT_THAT(missing.problem, HasSubstr("no polygons (layers: \"v\")"));
  EXPECT_THAT(line_fault(folder_ / "none.gpkg").problem, HasSubstr("no such file"));
  EXPECT_THAT(line_fault(folder_.write("a.geojson", "{")).problem, HasSubstr("cannot be read"));
}

TEST_F(Vectors, RefusesBrokenGeometries) {
  EXPECT_THAT(
      line_fault(geojson(R"({"type": "LineString", "coordinates": [[1, 1], [1, 1]]})", utm54_name_))
          .problem,
      HasSubstr("no length"));
  EXPECT_THAT(
      polygon_fault(geojson(R"({"type": "Polygon",)"
                            R"( "coordinates": [[[0, 0], [4, 4], [4, 0], [0, 4], [0, 0]]]})",
                            utm54_name_))
          .problem,
      HasSubstr("Self-intersection"));
}

TEST_F(Vectors, RefusesWhatCannotBeReprojected) {
  // Metres in a GeoJSON without a CRS, which then means degrees.
  const auto file = geojson(R"({"type": "LineString", "coordinates": [[5e5, 4e6], [6e5, 4e6]]})");
  EXPECT_THAT(line_fault(file).problem, HasSubstr("cannot be brought from EPSG:4326"));
  const auto degrees = geojson(R"({"type": "LineString", "coordinates": [[141, 0], [141, 1]]})");
  EXPECT_THAT(fault_of([&] { read_lines(degrees, "", "path.line"); }).problem,
              HasSubstr("in degrees"));
}

TEST_F(Vectors, RefusesTwoLayersOfTheSameKind) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  GDALDatasetUniquePtr data(
      driver->Create((folder_ / "two.gpkg").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  for (const char* name : {"upper", "lower"}) {
    OGRLayer* layer = data->CreateLayer(name, nullptr, wkbLineString, nullptr);
    OGRFeature feature(layer->GetLayerDefn());
    OGRLineString line;
    line.addPoint(0, 0);
    line.addPoint(1, 0);
    feature.SetGeometry(&line);
    ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }
  data.reset();
  EXPECT_THAT(line_fault(folder_ / "two.gpkg").problem,
              HasSubstr("in layers \"upper\" and \"lower\""));
}

TEST_F(Vectors, ReportsAFailedWrite) {
  const NamedLine line{"dam", {{{0, 0, 0}, {1, 0, 0}}, false}};
  EXPECT_THAT(run_error_of([&] { write_lines(folder_ / "no/dam.gpkg", {line}, ""); }),
              HasSubstr("cannot write"));
  const FullDisk full(8192);
  EXPECT_THAT(run_error_of([&] { write_lines(folder_ / "dam.gpkg", {line}, utm54_); }),
              HasSubstr("dam.gpkg"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "dam.gpkg"));
}

}  // namespace
}  // namespace sabo
