#include "run/scene.hpp"

#include <cmath>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "io/gis/write_raster.hpp"
#include "io/gis/write_vectors.hpp"
#include "run/input_files.hpp"
#include "run/preview.hpp"
#include "run/preview_picture.hpp"
#include "solver/flow_model.hpp"

// Cases on flat ground of 60 x 60 m at 100 m, cells of 1 m, without a coordinate system.

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

Raster flat() { return Raster(Grid{60, 60, 0, 60, 1, 1}, 100); }

struct FlatCase {
  TemporaryFolder folder;
  Faults faults;

  FlatCase() { write_raster(folder / "dem.tif", flat(), {"", "elevation", "m"}); }

  Case read(const std::string& keys) {
    return read_case_text(
        "terrain.dem = \"dem.tif\"\nterrain.assume_metres = true\nnumerics.spacing = 1\n"
        "run.duration = 1\n" +
            keys,
        folder / "", faults);
  }
  Scene make(const std::string& keys) {
    const Case c = read(keys);
    return make_scene(c, faults);
  }
  std::vector<std::string> messages() const {
    std::vector<std::string> texts;
    for (const Fault& fault : faults.list()) texts.push_back(to_string(fault));
    return texts;
  }
};

const std::string square_release =
    "release.polygon = [[20, 20], [30, 20], [30, 30], [20, 30]]\nrelease.thickness = 2\n";

TEST(Scene, EditsChangeTheGroundBeforeTheReleaseStandsOnIt) {
  FlatCase flat_case;
  const Scene scene = flat_case.make(square_release + R"([[terrain.edit]]
name = "pit"
kind = "lower"
by = 3
polygon = [[10, 10], [40, 10], [40, 40], [10, 40]]
[[terrain.edit]]
kind = "set"
elevation = 105
polygon = [[0, 0], [5, 0], [5, 5], [0, 5]]
)");
  ASSERT_TRUE(flat_case.faults.empty()) << flat_case.messages().front();
  EXPECT_EQ(scene.surface->height(25, 25), 97);
  EXPECT_EQ(scene.surface->height(2, 2), 105);
  EXPECT_EQ(scene.surface->height(55, 55), 100);
  ASSERT_EQ(scene.edits.size(), 2u);
  EXPECT_EQ(scene.edits[0].report.cut, 30 * 30 * 3);
  EXPECT_EQ(scene.edits[1].report.fill, 5 * 5 * 5);
  // Lowest particles: half a spacing above the lowered ground.
  double lowest = 1e9;
  for (const Vec3d& x : scene.release.position) lowest = std::min(lowest, x.z);
  EXPECT_EQ(lowest, 97.5);
}

TEST(Scene, EditsAndZonesBesideTheDemAreFaults) {
  FlatCase flat_case;
  flat_case.make(square_release + R"([[terrain.edit]]
kind = "lower"
by = 3
polygon = [[100, 10], [140, 10], [140, 40]]
[[zone]]
polygon = [[100, 10], [140, 10], [140, 40]]
)");
  EXPECT_THAT(flat_case.messages(),
              ElementsAre(HasSubstr("terrain.edit[1].polygon: holds no centre of a cell"),
                          HasSubstr("zone[1].polygon: holds no centre of a cell")));
}

TEST(Scene, ALineWhereThereIsNoGroundIsAFault) {
  FlatCase flat_case;
  Raster ground = flat();  // x and y of the hole: 40 to 50 m
  for (int row = 10; row < 20; ++row)
    for (int column = 40; column < 50; ++column) ground.at(column, row) = Raster::no_data;
  write_raster(flat_case.folder / "dem.tif", ground, {"", "elevation", "m"});
  flat_case.make(square_release +
                 "[[section]]\nname = \"a\"\nline = [[42, 42], [48, 48]]\n"
                 "[[section]]\nname = \"b\"\nline = [[70, 1], [80, 1]]\n");
  EXPECT_THAT(flat_case.messages(),
              ElementsAre(HasSubstr("section[1].line: the line lies where the DEM has no data"),
                          HasSubstr("section[2].line: the line lies beside the DEM")));
}

TEST(Scene, ReleaseIsWhatLiesBetweenTwoSurfaces) {
  FlatCase flat_case;
  // After the event: a pit of 10 x 10 m, 4 m deep; and a dent of 0.2 m that is noise.
  Raster after = flat();
  for (int row = 20; row < 30; ++row)
    for (int column = 20; column < 30; ++column) after.at(column, row) = 96;
  after.at(50, 50) = 99.8;
  write_raster(flat_case.folder / "after.tif", after, {"", "elevation", "m"});
  const Scene scene = flat_case.make(
      "release.dem_before = \"dem.tif\"\nrelease.dem_after = \"after.tif\"\n"
      "release.least_thickness = 0.5\n");
  ASSERT_TRUE(flat_case.faults.empty()) << flat_case.messages().front();
  EXPECT_NEAR(scene.release_volume, 400, 1e-9);
  EXPECT_NEAR(scene.release_area, 100, 1e-9);
  EXPECT_EQ(scene.release_depth, 4);
  ASSERT_TRUE(scene.lost);
  EXPECT_EQ(scene.lost->dug, 400);
  // The mass lies where it was: between 96 and 100 m.
  for (const Vec3d& x : scene.release.position) EXPECT_TRUE(x.z > 96 && x.z < 100) << x.z;
}

TEST(Scene, SwappedSurfacesAreAFault) {
  FlatCase flat_case;
  write_raster(flat_case.folder / "lower.tif", Raster(flat().grid, 90), {"", "elevation", "m"});
  flat_case.make("release.dem_before = \"lower.tif\"\nrelease.dem_after = \"dem.tif\"\n");
  EXPECT_THAT(flat_case.messages(),
              ElementsAre(HasSubstr("release.dem_before: is nowhere above dem_after")));
}

TEST(Scene, ThicknessOfEachPolygonMayComeFromItsAttribute) {
  FlatCase flat_case;
  flat_case.folder.write("release.geojson", R"({"type": "FeatureCollection",
"crs": {"type": "name", "properties": {"name": "EPSG:32652"}}, "features": [
{"type": "Feature", "properties": {"d0": 2}, "geometry": {"type": "Polygon",
 "coordinates": [[[10, 10], [20, 10], [20, 20], [10, 20], [10, 10]]]}},
{"type": "Feature", "properties": {"d0": 3.0}, "geometry": {"type": "Polygon",
 "coordinates": [[[30, 30], [40, 30], [40, 40], [30, 40], [30, 30]]]}}]})");
  const Scene scene = flat_case.make(
      "release.polygon = \"release.geojson\"\nrelease.thickness_attribute = \"d0\"\n");
  ASSERT_TRUE(flat_case.faults.empty()) << flat_case.messages().front();
  EXPECT_NEAR(scene.release_volume, 500, 1e-9);
  EXPECT_NEAR(scene.release_area, 200, 1e-9);
  EXPECT_EQ(scene.release_depth, 3);

  FlatCase& again = flat_case;
  again.make("release.polygon = \"release.geojson\"\nrelease.thickness_attribute = \"depth\"\n");
  EXPECT_THAT(again.messages(),
              ElementsAre(HasSubstr("has no attribute \"depth\"; use one of: \"d0\"")));
}

// 1.4 m at a spacing of 1 m: one particle, under the weight of 0.7 m.
TEST(Scene, AReleaseBetweenTwoSpacingsHasItsOwnDepthAndPressure) {
  FlatCase flat_case;
  const std::string keys =
      "release.polygon = [[20, 20], [30, 20], [30, 30], [20, 30]]\nrelease.thickness = 1.4\n";
  const Scene scene = flat_case.make(keys);
  ASSERT_TRUE(flat_case.faults.empty()) << flat_case.messages().front();
  ASSERT_EQ(scene.release.size(), 100u);
  EXPECT_NEAR(scene.release_depth, 1.4, 1e-12);
  const Case c = flat_case.read(keys);
  const Tait state = flow_model(c.material, c.numerics, scene.greatest_depth()).state;
  const double pressure = state.rho0 * c.numerics.gravity * 0.7;
  for (std::size_t k = 0; k < scene.release.size(); ++k) {
    EXPECT_NEAR(scene.release.position[k].z, 100.7, 1e-9);
    EXPECT_NEAR(state.pressure(scene.release.density[k]), pressure, 1e-6 * pressure);
  }
}

TEST(Scene, AreasWithoutAClearInsideOrOverEachOtherAreFaults) {
  FlatCase flat_case;
  const std::string bow = "polygon = [[10, 10], [20, 20], [20, 10], [10, 16]]\n";
  flat_case.make("release." + bow + "release.thickness = 2\n[[zone]]\n" + bow);
  EXPECT_THAT(flat_case.messages(),
              UnorderedElementsAre(HasSubstr("release.polygon: is no sound polygon: Self-inter"),
                                   HasSubstr("zone[1].polygon: is no sound polygon: Self-inter")));
  FlatCase twice;
  twice.folder.write("release.geojson", R"({"type": "FeatureCollection",
"crs": {"type": "name", "properties": {"name": "EPSG:32652"}}, "features": [
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",
 "coordinates": [[[10, 10], [20, 10], [20, 20], [10, 20], [10, 10]]]}},
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",
 "coordinates": [[[18, 10], [30, 10], [30, 20], [18, 20], [18, 10]]]}}]})");
  twice.make("release.polygon = \"release.geojson\"\nrelease.thickness = 2\n");
  EXPECT_THAT(twice.messages(),
              ElementsAre(HasSubstr("release.polygon: polygons 1 and 2 overlap by 20 m2")));
}

TEST(Scene, AThicknessThatIsATextIsReadWholeOrRefused) {
  const auto release = [](const std::string& value) {
    return R"({"type": "FeatureCollection",
"crs": {"type": "name", "properties": {"name": "EPSG:32652"}}, "features": [
{"type": "Feature", "properties": {"d": ")" +
           value + R"("}, "geometry": {"type": "Polygon",
 "coordinates": [[[10, 10], [20, 10], [20, 20], [10, 20], [10, 10]]]}}]})";
  };
  const std::string keys =
      "release.polygon = \"release.geojson\"\nrelease.thickness_attribute = \"d\"\n";
  FlatCase point;
  point.folder.write("release.geojson", release("2.5"));
  EXPECT_NEAR(point.make(keys).release_volume, 250, 1e-9);
  for (const std::string wrong : {"2,5", "2.5 m", "deep"}) {
    FlatCase other;
    other.folder.write("release.geojson", release(wrong));
    other.make(keys);
    EXPECT_THAT(other.messages(),
                ElementsAre(HasSubstr("whose \"d\" is \"" + wrong + "\", which is no number")));
  }
}

TEST(Scene, PreviewShowsEditsAndZones) {
  FlatCase flat_case;
  const Case c = flat_case.read(square_release + R"([material]
preset = "glass_beads"
[[terrain.edit]]
name = "pit <1>"
kind = "lower"
by = 3
polygon = [[10, 10], [40, 10], [40, 40], [10, 40]]
[[zone]]
name = "field"
polygon = [[40, 40], [50, 40], [50, 50], [40, 50]]
)");
  const Scene scene = make_scene(c, flat_case.faults);
  ASSERT_TRUE(flat_case.faults.empty()) << flat_case.messages().front();
  const std::string text = preview_text(c, scene);
  EXPECT_THAT(text, HasSubstr("pit <1>: 900 cells, 2700 m3 cut, 0 m3 filled, by up to 3.00 m"));
  EXPECT_THAT(text, HasSubstr("field: 100 m2"));
  EXPECT_THAT(text, HasSubstr("preset glass_beads: Jop, Forterre & Pouliquen"));
  const std::string svg = preview_svg(c, scene);
  EXPECT_THAT(svg, HasSubstr(">pit &lt;1&gt;</text>"));
  EXPECT_THAT(svg, HasSubstr(">field</text>"));
}

TEST(InputFiles, AreAllThatACaseNames) {
  FlatCase flat_case;
  std::filesystem::create_directories(flat_case.folder / "tiles" / "more");
  for (const char* file : {"tiles/b.xml", "tiles/more/a.xml", "area 1.shp", "area 1.dbf"})
    flat_case.folder.write(file, "");
  Case c = flat_case.read(
      "release.polygon = \"area 1.shp\"\nrelease.volume = 1\n"
      "[[zone]]\npolygon = \"area 1.shp\"\n");
  c.terrain.dem = flat_case.folder / "tiles";
  std::vector<std::string> names;
  for (const auto& file : input_files(c)) names.push_back(file.filename().string());
  EXPECT_THAT(names, ElementsAre("b.xml", "a.xml", "area 1.shp", "area 1.dbf"));
}

}  // namespace
}  // namespace sabo
