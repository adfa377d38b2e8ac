#include <cmath>

#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/read_case.hpp"
#include "run/dam_openings.hpp"
#include "run/overlay.hpp"
#include "run/preview.hpp"
#include "run/preview_picture.hpp"
#include "run/scene_structures.hpp"

// Structures on a plane of 60 x 40 m that falls to the east by 1 in 10, particles of 0.5 m.

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct SlopeWorld {
  TemporaryFolder folder;
  Faults faults;
  Case c;

  /// Slope of 1 in 10; at x the ground is at 0.1 (60 - x).
  Scene make(const std::string& keys) {
    c = read_case_text(
        "[terrain.plane]\nextent = [0, 0, 60, 40]\nslope = 5.710593137499643\n[numerics]\n"
        "spacing = 0.5\n[run]\nduration = 1\n[release]\n"
        "polygon = [[5, 15], [15, 15], [15, 25], [5, 25]]\nthickness = 2\n" +
            keys,
        folder / "", faults);
    return make_scene(c, faults);
  }
  std::vector<std::string> messages() const {
    std::vector<std::string> texts;
    for (const Fault& fault : faults.list()) texts.push_back(to_string(fault));
    return texts;
  }
  std::vector<std::string> faults_of(const std::string& keys) {
    make(keys);
    return messages();
  }
};

/// A dam across the slope at x = 40, where the ground is at 2 m; its faces stand at 2.1 and 1.9 m.
const std::string dam =
    "[[structure]]\nname = \"dam\"\nline = [[40, 10], [40, 30]]\nheight = 4\nthickness = 2\n";

const std::string two_houses = R"({"type": "FeatureCollection",
"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32652"}}, "features": [
{"type": "Feature", "properties": {"h": 5}, "geometry": {"type": "Polygon",
"coordinates": [[[30, 5], [36, 5], [36, 9], [30, 9], [30, 5]]]}},
{"type": "Feature", "properties": {"h": 6.5}, "geometry": {"type": "Polygon",
"coordinates": [[[36, 5], [40, 5], [40, 9], [36, 9], [36, 5]]]}}]})";

std::string houses(const std::string& keys = "height_attribute = \"h\"\n") {
  return "[[structure]]\nname = \"house\"\nkind = \"building\"\npolygon = \"a.geojson\"\n" + keys;
}

TEST(StructuresScene, SillsCountFromTheLowestGroundUnderTheOpening) {
  SlopeWorld world;
  const Scene scene = world.make(dam + R"([[structure.slit]]
centre = 4
width = 2
[[structure.slit]]
centre = 10
width = 3
sill = 1
height = 2
[[structure.slit]]
centre = 15
width = 2
sill_elevation = 3
)");
  ASSERT_THAT(world.messages(), IsEmpty());
  const std::vector<Opening>& openings = scene.dams[0].openings;
  ASSERT_EQ(openings.size(), 3u);
  EXPECT_EQ(openings[0].from, 3);
  EXPECT_EQ(openings[0].to, 5);
  EXPECT_TRUE(std::isinf(openings[0].bottom) && std::isinf(openings[0].top));
  EXPECT_NEAR(openings[1].bottom, 1.9 + 1, 1e-9);
  EXPECT_NEAR(openings[1].top, 1.9 + 1 + 2, 1e-9);
  EXPECT_NEAR(openings[2].bottom, 3, 1e-9);
}

TEST(StructuresScene, AsManyGapsAsFitStandInTheMiddleOfAGrid) {
  // Gaps of 2 m and posts of 1 m: 4 x 2 + 3 x 1 = 11 of 12 m.
  GridCase twelve;
  twelve.from = 4;
  twelve.to = 16;
  twelve.gap = 2;
  twelve.post_width = 1;
  const GridLayout layout = grid_layout(twelve);
  EXPECT_EQ(layout.gaps, 4);
  EXPECT_NEAR(layout.from(0), 4.5, 1e-12);
  EXPECT_NEAR(layout.from(3) + 2, 15.5, 1e-12);
  twelve.to = 15;
  EXPECT_EQ(grid_layout(twelve).gaps, 4);

  SlopeWorld world;
  const Scene scene =
      world.make(dam +
                 "[[structure.grid]]\nfrom = 4\nto = 16\ngap = 2\npost_width = 1\npost_depth = 1\n"
                 "beam_gap = 1.5\nbeam_height = 0.5\n");
  ASSERT_THAT(world.messages(), IsEmpty());
  const CheckDam& grid = scene.dams[0];
  const double ground = 2;
  EXPECT_TRUE(grid.contains({40, 17, ground + 1}));       // the first post, from 16.5 to 17.5 m
  EXPECT_FALSE(grid.contains({40.6, 17, ground + 1}));    // beside it, in the thickness of the dam
  EXPECT_FALSE(grid.contains({40, 15.5, ground + 1}));    // the first gap
  EXPECT_TRUE(grid.contains({40, 15.5, ground + 1.6}));   // the first beam, from 1.4 to 1.9 m
  EXPECT_FALSE(grid.contains({40, 15.5, ground + 2.5}));  // over it
  EXPECT_TRUE(grid.contains({40, 14.2, ground + 1}));     // the wall beside the grid
  EXPECT_THAT(preview_text(world.c, scene),
              HasSubstr("grid of 4 gaps of 2 m, posts 1 m wide, from 4.50 to 15.50 m"));
}

TEST(StructuresScene, OpeningsOfFewParticlesAreTold) {
  const auto slit = [](const char* width) {
    return dam + "[[structure.slit]]\ncentre = 9\nwidth = " + width + "\n";
  };
  SlopeWorld enough;
  const Scene fine = enough.make(slit("2"));
  EXPECT_THAT(preview_text(enough.c, fine), Not(HasSubstr("Be aware")));
  SlopeWorld few;
  const Scene coarse = few.make(slit("1.4"));
  EXPECT_THAT(preview_text(few.c, coarse),
              HasSubstr("\"dam\": slit[1].width = 1.4 m is only 2.8 particles"));
  EXPECT_THAT(preview_text(few.c, coarse), HasSubstr("numerics.spacing is 0.35 m or less"));
  SlopeWorld closed;
  EXPECT_THAT(closed.faults_of(slit("0.9")),
              ElementsAre(HasSubstr("structure[1].slit[1].width: 0.9 m is less than 2 particle "
                                    "spacings of 0.5 m, so that nothing can pass; give a wider "
                                    "opening, or numerics.spacing = 0.225 m")));
}

TEST(StructuresScene, OpeningsOffTheLineOfAFileOrAboveTheCrestAreFaults) {
  SlopeWorld world;
  world.folder.write("dam.geojson",
                     R"({"type": "LineString", "coordinates": [[40, 10, 6], [40, 30, 6]],
"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32652"}}})");
  const std::string keys = "[[structure]]\nthickness = 2\nline = \"dam.geojson\"\n";
  EXPECT_THAT(world.faults_of(keys + "[[structure.slit]]\ncentre = 19.5\nwidth = 2\n"),
              ElementsAre(HasSubstr("reaches from 18.5 to 20.5 m along the line; the line is "
                                    "20.00 m long")));
  SlopeWorld other;
  other.folder.write("dam.geojson", world.folder.read("dam.geojson"));
  EXPECT_THAT(other.faults_of(keys + "[[structure.slit]]\ncentre = 9\nwidth = 2\nsill = 5\n"),
              ElementsAre(HasSubstr("begins at 6.90 m, which is not below the crest at 6.00 m")));
}

TEST(StructuresScene, ADeflectionWallFollowsTheGround) {
  SlopeWorld world;
  const Scene scene = world.make(
      "[[structure]]\nname = \"wall\"\nkind = \"deflection_wall\"\nline = [[20, 5], [50, 5]]\n"
      "height = 3\nthickness = 1\n" +
      dam);
  ASSERT_THAT(world.messages(), IsEmpty());
  ASSERT_EQ(scene.dams.size(), 2u);
  EXPECT_EQ(scene.check_dams().size(), 1u);
  EXPECT_EQ(scene.dams[0].name, "dam");  // check dams are the first
  const CheckDam& wall = scene.dams[1];
  for (const double x : {21.3, 35.0, 49.9}) EXPECT_NEAR(wall.top(x - 20), 0.1 * (60 - x) + 3, 1e-9);
  EXPECT_THAT(preview_text(world.c, scene),
              HasSubstr("wall: 30.0 m long, 1 m thick, crest at 4.00 to 7.00 m, up to 3.00 m"));
}

TEST(StructuresScene, BuildingsOfAFileAreNumberedBodies) {
  SlopeWorld world;
  world.folder.write("a.geojson", two_houses);
  const Scene scene = world.make(dam + houses() +
                                 "[[body]]\nname = \"box\"\nkind = \"box\"\nmin = [20, 1, 0]\n"
                                 "max = [22, 3, 6]\n");
  ASSERT_THAT(world.messages(), IsEmpty());
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].name(), "box");
  EXPECT_EQ(scene.bodies[1].name(), "house 1");
  EXPECT_EQ(scene.bodies[2].name(), "house 2");
  // The lowest ground is at their eastern sides, x = 36 and 40.
  EXPECT_NEAR(scene.buildings[0].top, 2.4 + 5, 1e-9);
  EXPECT_NEAR(scene.bodies[2].bounds().high.z, 2 + 6.5, 1e-9);
  EXPECT_THAT(preview_text(world.c, scene),
              HasSubstr("house: 2 buildings over 40.0 m2, 5.00 to 6.50 m above the lowest ground"));
  EXPECT_THAT(preview_svg(world.c, scene), HasSubstr(">house 2</text>"));
  EXPECT_EQ(label_of_body(scene, 2), "house 2");
}

// So many labels would hide the map; the lines know whose they are all the same.
TEST(StructuresScene, OfManyBuildingsOneIsLabelledAndAllAreNamed) {
  SlopeWorld world;
  std::string file = two_houses.substr(0, two_houses.find("{\"type\": \"Feature\""));
  for (int k = 0; k < 13; ++k)
    file += fmt::format(
        R"({}{{"type": "Feature", "properties": {{"h": 5}}, "geometry": {{"type": "Polygon",
"coordinates": [[[{}, 5], [{}, 5], [{}, 9], [{}, 9], [{}, 5]]]}}}})",
        k == 0 ? "" : ",", 10 + 2 * k, 12 + 2 * k, 12 + 2 * k, 10 + 2 * k, 10 + 2 * k);
  world.folder.write("a.geojson", file + "]}");
  const std::vector<MapLine> lines = overlay(world.make(dam + houses()));
  ASSERT_THAT(world.messages(), IsEmpty());
  std::vector<std::string> labels, names;
  for (const MapLine& line : lines) {
    if (line.kind != MapLine::Kind::dam || line.name_or_label() == "dam") continue;
    names.push_back(line.name_or_label());
    if (!line.label.empty()) labels.push_back(line.label);
  }
  ASSERT_EQ(names.size(), 13u);
  EXPECT_EQ(names[0], "house 1");
  EXPECT_EQ(names[12], "house 13");
  EXPECT_THAT(labels, ElementsAre("house"));
}

TEST(StructuresScene, BadBuildingsAreFaults) {
  const auto fault = [](const std::string& file, const std::string& keys) {
    SlopeWorld world;
    world.folder.write("a.geojson", file);
    const std::vector<std::string> found = world.faults_of(keys);
    return found.size() == 1 ? found.front() : std::to_string(found.size()) + " faults";
  };
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(fault(two_houses, houses("height_attribute = \"heigt\"\n")),
              HasSubstr("has no attribute \"heigt\"; use one of: \"h\""));
  EXPECT_THAT(fault(with(two_houses, "\"h\": 6.5", "\"h\": -1"), houses()),
              HasSubstr("has a building, number 2, with h = -1; give a height above 0"));
  EXPECT_THAT(fault(with(two_houses, "\"h\": 6.5", "\"h\": null"), houses()),
              HasSubstr("has a feature without a value of \"h\""));
  EXPECT_THAT(fault(with(two_houses, "[[[36, 5], [40, 5], [40, 9], [36, 9], [36, 5]]]",
                         "[[[35, 5], [40, 5], [40, 9], [36, 9], [35, 5]]]"),
                    houses()),
              HasSubstr("\"house 1\" and \"house 2\" overlap by 2 m2"));
  EXPECT_THAT(
      fault(with(two_houses, "[36, 5], [36, 9], [30, 9]", "[36, 9], [36, 5], [30, 9]"), houses()),
      HasSubstr("has an invalid polygon"));
  EXPECT_THAT(fault(with(two_houses, "[40, 5], [40, 9]", "[70, 5], [70, 9]"), houses()),
              HasSubstr("\"house 2\" has a corner outside the DEM at (70.00, 5.00)"));
  EXPECT_THAT(fault(two_houses,
                    "[[structure]]\nkind = \"building\"\nheight = 3\n"
                    "polygon = [[0, 0], [9, 9], [9, 0], [0, 9]]\n"),
              HasSubstr("structure[1].polygon: is no sound polygon: Self-intersection[4.5 4.5]"));
  EXPECT_THAT(fault(two_houses, houses() + "[[body]]\nname = \"house 2\"\nkind = \"box\"\n"
                                           "min = [20, 1, 0]\nmax = [22, 3, 6]\n"),
              HasSubstr("\"house 2\" is the name of two structures or bodies"));
}

TEST(StructuresScene, TheReleaseLeavesStructuresOut) {
  SlopeWorld world;
  // Over half of the 200 m3, to the plane at x = 10, and a quarter of a spacing beside it.
  const Scene scene = world.make(
      "[[structure]]\nkind = \"building\"\nheight = 9\n"
      "polygon = [[1, 11], [10, 11], [10, 29], [1, 29]]\n");
  ASSERT_THAT(world.messages(), IsEmpty());
  EXPECT_NEAR(scene.release_volume, 100, 1e-9);
  EXPECT_NEAR(scene.release_left_out, 100, 1e-9);
  for (const Vec3d& x : scene.release.position) EXPECT_GT(x.x, 10);
  EXPECT_THAT(preview_text(world.c, scene),
              HasSubstr("100 m3 of the release would stand inside structures"));
  SlopeWorld all;
  EXPECT_THAT(all.faults_of("[[structure]]\nkind = \"building\"\nheight = 9\n"
                            "polygon = [[1, 11], [20, 11], [20, 29], [1, 29]]\n"),
              ElementsAre(HasSubstr("release: all of it lies inside of structures or bodies")));
}

TEST(StructuresScene, MapsShowTheGapsOfADam) {
  SlopeWorld world;
  const Scene scene = world.make(dam +
                                 "[[structure.slit]]\ncentre = 8\nwidth = 2\n"
                                 "[[structure.slit]]\ncentre = 15\nwidth = 2\nheight = 1\n");
  std::vector<MapLine> pieces;
  for (const MapLine& line : overlay(scene))
    if (line.kind == MapLine::Kind::dam) pieces.push_back(line);
  ASSERT_EQ(pieces.size(), 2u);  // the culvert has a wall over it
  EXPECT_EQ(pieces[0].label, "dam");
  EXPECT_EQ(pieces[1].label, "");
  EXPECT_EQ(pieces[1].name, "dam");
  EXPECT_NEAR(pieces[0].line.vertices.back().y, 17, 1e-9);
  EXPECT_NEAR(pieces[1].line.vertices.front().y, 19, 1e-9);
  EXPECT_NEAR(pieces[1].line.vertices.back().y, 30, 1e-9);
}

TEST(StructuresExamples, AreSound) {
  for (const char* name : {"slit-dam", "houses", "inflow"}) {
    Faults faults;
    const Case c = read_case(repository() / "examples" / name, faults);
    const Scene scene = make_scene(c, faults);
    for (const Fault& fault : faults.list()) ADD_FAILURE() << name << ": " << to_string(fault);
    EXPECT_EQ(scene.release_left_out, 0) << name;
    EXPECT_THAT(preview_text(c, scene), Not(HasSubstr("particles; what passes"))) << name;
  }
}

}  // namespace
}  // namespace sabo
