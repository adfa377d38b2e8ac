#include "io/output/plan_file.hpp"

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "io/gis/crs.hpp"

namespace sabo {
namespace {

std::string utm_52() {
  OGRSpatialReference crs;
  crs.importFromEPSG(32652);
  return wkt_of(crs);
}

const std::vector<MapLine> lines{
    {MapLine::Kind::path, "", {{{350000.25, 3130000, 0}, {350010, 3130001.125, 0}}, false}},
    {MapLine::Kind::dam,
     "No. 1 \"堰堤\" \\",
     {{{350005, 3129990, 12.5}, {350005, 3130010, 13}}, true}},
    {MapLine::Kind::zone, "fan", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, false}},
    {MapLine::Kind::dam, "house", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, false}, true},
    {MapLine::Kind::dam, "", {{{2, 0, 0}, {3, 0, 0}}, false}, true, "house 2"}};

TEST(PlanFile, ComesBackAsWritten) {
  const TemporaryFolder folder;
  write_plan(folder / "plan.geojson", lines, utm_52());
  const std::vector<MapLine> read = read_plan(folder / "plan.geojson");
  ASSERT_EQ(read.size(), lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_EQ(read[k].kind, lines[k].kind);
    EXPECT_EQ(read[k].label, lines[k].label);
    EXPECT_EQ(read[k].name, lines[k].name_or_label());
    EXPECT_EQ(read[k].is_filled, lines[k].is_filled);
    EXPECT_EQ(read[k].line.has_z, lines[k].line.has_z);
    ASSERT_EQ(read[k].line.vertices.size(), lines[k].line.vertices.size());
    for (std::size_t i = 0; i < lines[k].line.vertices.size(); ++i) {
      EXPECT_DOUBLE_EQ(read[k].line.vertices[i].x, lines[k].line.vertices[i].x);
      EXPECT_DOUBLE_EQ(read[k].line.vertices[i].y, lines[k].line.vertices[i].y);
      EXPECT_DOUBLE_EQ(read[k].line.vertices[i].z, lines[k].line.vertices[i].z);
    }
  }
}

TEST(PlanFile, SaysItsCoordinateSystemToOtherSoftware) {
  const TemporaryFolder folder;
  write_plan(folder / "plan.geojson", lines, utm_52());
  const GDALDatasetUniquePtr data(
      GDALDataset::Open((folder / "plan.geojson").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(data);
  const OGRSpatialReference* crs = data->GetLayer(0)->GetSpatialRef();
  ASSERT_TRUE(crs);
  EXPECT_EQ(code_of(*crs), "EPSG:32652");
}

TEST(PlanFile, LeavesOutWhatIsNoLineOfItsKind) {
  const TemporaryFolder folder;
  const auto file = folder.write("plan.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"kind": "castle", "name": "a"},
     "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}},
    {"type": "Feature", "properties": {"kind": "zone", "name": "b"},
     "geometry": {"type": "Point", "coordinates": [0, 0]}},
    {"type": "Feature", "properties": {"kind": "zone", "name": "c"}, "geometry": null},
    {"type": "Feature", "properties": {"kind": "zone", "name": "d"},
     "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}]})");
  const std::vector<MapLine> read = read_plan(file);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].label, "d");
}

TEST(PlanFile, RefusesWhatCannotBeRead) {
  const TemporaryFolder folder;
  for (const char* text : {"", "no JSON", "{\"type\": \"FeatureCollection\", \"features\": [3"})
    EXPECT_NE(fault_of([&] { read_plan(folder.write("plan.geojson", text)); }).problem, "") << text;
}

}  // namespace
}  // namespace sabo
