#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Faults of the smallest case with the keys of [release], which start at line 4, replaced.
std::vector<std::string> release(const std::string& keys) {
  return messages(with(smallest_case, "polygon = \"release.gpkg\"\nvolume = 100\n", keys));
}

/// Faults of the smallest case with a dam, whose keys start at line 12.
std::vector<std::string> dam(const std::string& keys) {
  return messages(smallest_case + "[[structure]]\nthickness = 3\n" + keys);
}

TEST(Rules, OneWayOfRelease) {
  EXPECT_THAT(release(""),
              ElementsAre("case.toml:3 release: nothing is released; "
                          "give one of polygon, thickness_raster, points, box, and dem_before "
                          "with dem_after, or an [[inflow]]"));
  EXPECT_THAT(release("polygon = \"release.gpkg\"\nvolume = 1\npoints = \"points.txt\"\n"),
              ElementsAre("case.toml:3 release: the release is given in more than one way; "
                          "give one of polygon, thickness_raster, points, box, and dem_before "
                          "with dem_after"));
}

TEST(Rules, ABoxHasAVolumeOfItsOwn) {
  EXPECT_THAT(release("box = [0, 0, 0, 1, 1, 1]\n"), IsEmpty());
  EXPECT_THAT(release("box = [0, 0, 0, 1, -1, 1]\n"),
              ElementsAre("case.toml:4 release.box: has no volume; "
                          "give [x0, y0, z0, x1, y1, z1], the lower corner first"));
  EXPECT_THAT(
      release("box = [0, 0, 0, 1, 1, 1]\nvolume = 3\nnormal = true\nthickness = 1\n"),
      ElementsAre(
          "case.toml:7 release.thickness: applies to a polygon only; remove it",
          "case.toml:5 release.volume: does not apply to a box; remove it, or change the box",
          "case.toml:6 release.normal: does not apply to a box; remove it"));
}

/// Faults of the smallest case with other keys in [terrain], which start at line 2.
std::vector<std::string> terrain(const std::string& keys) {
  return messages(with(smallest_case, "dem = \"dem.tif\"\n", keys));
}

TEST(Rules, TheGroundIsADemOrAPlane) {
  EXPECT_THAT(terrain("plane.extent = [0, 0, 9, 9]\n"), IsEmpty());
  EXPECT_THAT(terrain(""),
              ElementsAre("case.toml:1 terrain: has no ground; give one of dem and plane"));
  EXPECT_THAT(terrain("dem = \"dem.tif\"\nplane.extent = [0, 0, 9, 9]\n"),
              ElementsAre("case.toml:1 terrain: has a dem and a plane; give one of dem and plane"));
  EXPECT_THAT(terrain("plane.extent = [0, 0, 9, 0]\n"),
              ElementsAre("case.toml:2 terrain.plane.extent: is empty; "
                          "give [west, south, east, north]"));
  EXPECT_THAT(terrain("plane.slope = 3\n"),
              ElementsAre("case.toml:2 terrain.plane.extent: is missing; "
                          "give [4 numbers], each from -1e8 to 1e8 m"));
  EXPECT_THAT(terrain("plane.extent = [0, 0, 9, 9]\ncrs = \"EPSG:6670\"\ncell_size = 1\n"),
              ElementsAre("case.toml:3 terrain.crs: applies to a dem only; remove it",
                          "case.toml:4 terrain.cell_size: applies to a dem only; remove it"));
}

/// Faults of the smallest case with a body, whose keys start at line 12.
std::vector<std::string> body(const std::string& keys) {
  return messages(smallest_case + "[[body]]\n" + keys);
}

TEST(Rules, ABodyHasTheKeysOfItsKind) {
  EXPECT_THAT(body("kind = \"box\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nrotation = 30\n"), IsEmpty());
  EXPECT_THAT(body("kind = \"tank\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nopen_top = false\n"),
              IsEmpty());
  EXPECT_THAT(body("kind = \"mesh\"\nfile = \"mesh.stl\"\nflow = \"inside\"\n"), IsEmpty());
  EXPECT_THAT(
      body("kind = \"box\"\nmax = [1, 1, 1]\nopen_top = false\nscale = 2\n"),
      ElementsAre("case.toml:11 body[1].min: is missing; give its lowest corner [x, y, z]",
                  "case.toml:14 body[1].open_top: does not apply to kind \"box\"; remove it",
                  "case.toml:15 body[1].scale: does not apply to kind \"box\"; remove it"));
  EXPECT_THAT(
      body("kind = \"mesh\"\nframe = \"local\"\nrotation = 2\n"),
      ElementsAre("case.toml:14 body[1].rotation: does not apply to kind \"mesh\"; remove it",
                  "case.toml:11 body[1].file: is missing; give an STL or OBJ file",
                  "case.toml:11 body[1].at: is missing; "
                  "give the place of its origin [x, y, z]"));
  EXPECT_THAT(body("kind = \"box\"\nmin = [0, 0, 2]\nmax = [1, 1, 1]\n"),
              ElementsAre("case.toml:14 body[1].max: its z is not above that of min; "
                          "give corners across from each other, the lower one as min"));
}

TEST(Rules, PolygonHasThicknessOrVolume) {
  EXPECT_THAT(release("polygon = \"release.gpkg\"\n"),
              ElementsAre("case.toml:4 release.polygon: has no thickness and no volume; "
                          "give thickness, thickness_attribute or volume"));
  EXPECT_THAT(release("polygon = \"release.gpkg\"\nvolume = 1\nthickness = 1\n"),
              ElementsAre("case.toml:4 release.polygon: has a thickness and a volume; "
                          "give one of the two"));
  EXPECT_THAT(release("polygon = [[0, 0], [1, 0], [1, 1]]\nthickness = 1\nnormal = true\n"),
              IsEmpty());
}

TEST(Rules, ThicknessMayComeFromAnAttribute) {
  EXPECT_THAT(release("polygon = \"release.gpkg\"\nthickness_attribute = \"d0\"\n"), IsEmpty());
  EXPECT_THAT(release("polygon = \"release.gpkg\"\nthickness_attribute = \"d0\"\nvolume = 1\n"),
              IsEmpty());
  EXPECT_THAT(
      release("polygon = \"release.gpkg\"\nthickness = 1\nthickness_attribute = \"d0\"\n"),
      ElementsAre("case.toml:6 release.thickness_attribute: the polygon has a thickness too; "
                  "give one of the two"));
  EXPECT_THAT(release("polygon = [[0, 0], [1, 0], [1, 1]]\nthickness_attribute = \"d0\"\n"),
              ElementsAre("case.toml:5 release.thickness_attribute: a polygon given by coordinates "
                          "has no attributes; give thickness"));
}

TEST(Rules, DemsBeforeAndAfterAreAPair) {
  const std::string both = "dem_before = \"dem.tif\"\ndem_after = \"release.tif\"\n";
  EXPECT_THAT(release(both), IsEmpty());
  EXPECT_THAT(release(both + "polygon = \"release.gpkg\"\nleast_thickness = 0.5\n"), IsEmpty());
  EXPECT_THAT(release("dem_before = \"dem.tif\"\n"),
              ElementsAre("case.toml:4 release.dem_before: is one of a pair; give dem_after too"));
  EXPECT_THAT(
      release(both + "thickness = 1\nnormal = true\n"),
      ElementsAre("case.toml:7 release.normal: does not apply to a difference of elevations;"
                  " remove it",
                  "case.toml:6 release.thickness: applies to a polygon only; remove it"));
  EXPECT_THAT(
      release("thickness_raster = \"release.tif\"\nleast_thickness = 1\n"),
      ElementsAre("case.toml:5 release.least_thickness: applies to dem_before and dem_after "
                  "only; remove it"));
}

TEST(Rules, PolygonHasThreeCorners) {
  EXPECT_THAT(release("polygon = [[0, 0], [1, 0]]\nvolume = 1\n"),
              ElementsAre("case.toml:4 release.polygon: has fewer than three points; "
                          "give three or more"));
}

TEST(Rules, AFaultyKeyCountsAsGiven) {
  EXPECT_THAT(release("polygon = \"release.gpkg\"\nvolume = -1\n"),
              ElementsAre("case.toml:5 release.volume: -1 is out of range; "
                          "give a number above 0, at most 1e12 m3"));
}

TEST(Rules, RasterTakesAVolumeButNoThickness) {
  EXPECT_THAT(release("thickness_raster = \"release.tif\"\n"), IsEmpty());
  EXPECT_THAT(release("thickness_raster = \"release.tif\"\nvolume = 1\n"), IsEmpty());
  EXPECT_THAT(release("thickness_raster = \"release.tif\"\nthickness = 1\n"),
              ElementsAre("case.toml:5 release.thickness: applies to a polygon only; remove it"));
}

TEST(Rules, PointsStandAlone) {
  EXPECT_THAT(release("points = \"points.txt\"\npoint_volume = 2\npoints_offset = [1, 2, 3]\n"),
              IsEmpty());
  EXPECT_THAT(release("points = \"points.txt\"\nthickness = 1\nvolume = 1\nnormal = true\n"),
              ElementsAre("case.toml:5 release.thickness: applies to a polygon only; remove it",
                          "case.toml:6 release.volume: does not apply to points; "
                          "remove it; each point stands for point_volume",
                          "case.toml:7 release.normal: does not apply to points; remove it"));
}

TEST(Rules, ASeedNeedsAJitter) {
  const std::string raster = "thickness_raster = \"release.tif\"\n";
  EXPECT_THAT(release(raster + "jitter = 0.1\nseed = 3\n"), IsEmpty());
  EXPECT_THAT(
      release(raster + "seed = 3\n"),
      ElementsAre("case.toml:5 release.seed: has no effect without jitter; give jitter, 0.1 "
                  "for instance"));
  EXPECT_THAT(release(raster + "jitter = 0.31\nseed = 3\n").size(), 1u);
}

TEST(Rules, KeysOfPointsNeedPoints) {
  EXPECT_THAT(release("polygon = \"release.gpkg\"\nvolume = 1\npoint_volume = 2\n"
                      "points_offset = [1, 0, 0]\n"),
              ElementsAre("case.toml:6 release.point_volume: applies to points only; remove it",
                          "case.toml:7 release.points_offset: applies to points only; remove it"));
}

TEST(Rules, CropHasAnInside) {
  EXPECT_THAT(messages(with(smallest_case, "[release]", "crop = [5, 0, 5, 10]\n[release]")),
              ElementsAre("case.toml:3 terrain.crop: the window is empty; "
                          "give [west, south, east, north]"));
}

/// Faults of the smallest case with an edit of the terrain, whose keys start at line 12.
std::vector<std::string> edit(const std::string& keys) {
  return messages(smallest_case + "[[terrain.edit]]\n" + keys +
                  "polygon = [[0, 0], [1, 0], [1, 1]]\n");
}

TEST(Rules, EveryEditHasTheKeyOfItsKind) {
  EXPECT_THAT(edit("kind = \"set\"\nelevation = 100\n"), IsEmpty());
  EXPECT_THAT(edit("kind = \"lower\"\nby = 2\n"), IsEmpty());
  EXPECT_THAT(edit("kind = \"raise\"\nby = 2\n"), IsEmpty());
  EXPECT_THAT(edit("kind = \"smooth\"\nradius = 5\n"), IsEmpty());
  EXPECT_THAT(edit("kind = \"smooth\"\nby = 2\n"),
              ElementsAre("case.toml:13 terrain.edit[1].by: does not apply to kind \"smooth\"; "
                          "remove it",
                          "case.toml:11 terrain.edit[1].radius: is missing for kind \"smooth\"; "
                          "give it, in m"));
  EXPECT_THAT(edit("kind = \"dig\"\nby = 2\n"),
              ElementsAre("case.toml:12 terrain.edit[1].kind: \"dig\" is not known; give \"set\", "
                          "\"lower\", \"raise\" or \"smooth\""));
}

TEST(Rules, ZonesAreAreas) {
  EXPECT_THAT(messages(smallest_case + "[[zone]]\npolygon = [[0, 0], [1, 0]]\n"),
              ElementsAre("case.toml:12 zone[1].polygon: has fewer than three points; "
                          "give three or more"));
}

TEST(Rules, ConcentrationAndViscosityAgree) {
  // 0.621 exp(0.173 x 44) = 1255.86
  const std::string at_44 = smallest_case + "[material]\nconcentration = 44\n";
  EXPECT_THAT(messages(at_44), IsEmpty());
  EXPECT_THAT(messages(at_44 + "viscosity = 500\n"),
              ElementsAre("case.toml:12 material.concentration: gives a viscosity of 1255.86 Pa s, "
                          "the key viscosity says 500; remove one of the two"));
  EXPECT_THAT(messages(at_44 + "rheology = \"mu_i\"\n"),
              ElementsAre("case.toml:12 material.concentration: rheology \"mu_i\" has no "
                          "viscosity; remove it, or choose another rheology"));
}

TEST(Rules, KindOfStructure) {
  EXPECT_THAT(dam("line = \"dam.gpkg\"\nkind = \"net\"\n"),
              ElementsAre("case.toml:14 structure[1].kind: \"net\" is not known; "
                          "give \"check_dam\", \"deflection_wall\" or \"building\""));
}

TEST(Rules, DamHasOneCrest) {
  EXPECT_THAT(dam("line = \"dam.gpkg\"\ncrest = 20\n"), IsEmpty());
  EXPECT_THAT(dam("line = \"dam.gpkg\"\n"), IsEmpty());  // its file may have z
  EXPECT_THAT(dam("line = [[0, 0, 9], [1, 0, 9]]\n"), IsEmpty());
  EXPECT_THAT(dam("line = \"dam.gpkg\"\ncrest = 20\nheight = 8\n"),
              ElementsAre("case.toml:11 structure[1]: has a crest and a height; "
                          "give one of the two"));
  EXPECT_THAT(dam("line = [[0, 0], [1, 0]]\n"),
              ElementsAre("case.toml:11 structure[1]: has no crest; "
                          "give crest, height, or a line with z"));
  EXPECT_THAT(dam("line = [[0, 0, 9], [1, 0, 9]]\nheight = 8\n"),
              ElementsAre("case.toml:14 structure[1].height: the z of the line is the crest "
                          "already; remove one of the two"));
}

TEST(Rules, NotchLiesInTheDam) {
  EXPECT_THAT(dam("line = [[0, 0], [30, 40]]\nheight = 8\n"
                  "notch = {centre = 51, width = 4, depth = 9}\n"),
              ElementsAre("case.toml:15 structure[1].notch.depth: the notch is deeper than the dam "
                          "is high; give at most 8 m",
                          "case.toml:15 structure[1].notch.centre: lies beyond the end of the "
                          "line; give a distance along the line, at most 50 m"));
  EXPECT_THAT(dam("line = [[0, 0], [30, 40]]\nheight = 8\n"
                  "notch = {centre = 25, width = 60, depth = 1.5}\n"),
              ElementsAre("case.toml:15 structure[1].notch.width: the notch is wider than the dam "
                          "is long; give at most 50 m"));
  EXPECT_THAT(dam("line = [[0, 0], [30, 40]]\nheight = 8\n"
                  "notch = {centre = 25, width = 4, depth = 1.5}\n"),
              IsEmpty());
}

TEST(Rules, LinesHaveALength) {
  EXPECT_THAT(messages(smallest_case + "[path]\nline = [[1, 1], [1, 1]]\n"),
              ElementsAre("case.toml:12 path.line: all its points are at one place; "
                          "give a line of some length"));
}

TEST(Rules, GaugesHaveOnePlaceOrAFile) {
  EXPECT_THAT(messages(smallest_case + "[[gauge]]\nplace = [1, 2]\n"), IsEmpty());
  EXPECT_THAT(
      messages(smallest_case + "[[gauge]]\nname = \"a\"\n"),
      ElementsAre("case.toml:11 gauge[1]: has no place; give one of place = [x, y] and file"));
  EXPECT_THAT(
      messages(smallest_case + "[[gauge]]\nplace = [1, 2]\nfile = \"path.gpkg\"\n"),
      ElementsAre("case.toml:11 gauge[1]: has a place and a file; give one of place = [x, y] "
                  "and file"));
}

TEST(Rules, NamesAreUnique) {
  EXPECT_THAT(messages(smallest_case + "[[section]]\nname = \"a\"\nline = \"path.gpkg\"\n"
                                       "[[section]]\nname = \"a\"\nline = \"path.gpkg\"\n"),
              ElementsAre("case.toml:15 section[2].name: \"a\" is the name of section[1] too; "
                          "give each its own name"));
}

TEST(Rules, WithoutGravityASpeedIsNeeded) {
  EXPECT_THAT(messages(smallest_case + "gravity = 0\n"),
              ElementsAre("case.toml:8 numerics.reference_speed: without gravity nothing else sets "
                          "the sound speed; give a number above 0"));
  EXPECT_THAT(messages(smallest_case + "gravity = 0\nreference_speed = 1\n"), IsEmpty());
}

TEST(Rules, OutputsAreNotWithoutBound) {
  EXPECT_THAT(messages(with(smallest_case, "duration = 10",
                            "duration = 1e6\noutput_interval = 1\nseries_interval = 0.01")),
              ElementsAre("case.toml:8 run.output_interval: makes more than 100000 frames; "
                          "give at least 10 s",
                          "case.toml:9 run.series_interval: makes more than 1e7 rows; "
                          "give at least 0.1 s"));
  EXPECT_THAT(
      messages(
          with(smallest_case, "duration = 10", "duration = 1e4\nkept_checkpoint_interval = 1")),
      ElementsAre("case.toml:8 run.kept_checkpoint_interval: makes more than 1000 checkpoints; "
                  "give at least 10 s"));
}

TEST(Rules, KeysOfOneMethodAreRefusedByTheOther) {
  EXPECT_THAT(
      messages(smallest_case + "viscous_operator = \"morris\"\n"),
      ElementsAre("case.toml:11 numerics.viscous_operator: applies to method \"paper\" only; "
                  "remove it, or choose method = \"paper\""));
  EXPECT_THAT(messages(smallest_case + "method = \"paper\"\nwall = \"slip\"\n"),
              ElementsAre("case.toml:12 numerics.wall: applies to method \"fast\" only; "
                          "remove it, or choose boundary_stress"));
  EXPECT_THAT(messages(smallest_case + "method = \"paper\"\nparticle_shifting = 20\n"),
              ElementsAre("case.toml:12 numerics.particle_shifting: applies to method \"fast\" "
                          "only; remove it, or choose method = \"fast\""));
  EXPECT_THAT(messages(smallest_case + "method = \"paper\"\nsleep_time = 2\n"),
              ElementsAre("case.toml:12 numerics.sleep_time: applies to method \"fast\" only; "
                          "remove it, or choose method = \"fast\""));
  EXPECT_THAT(messages(smallest_case + "method = \"paper\"\nviscous_operator = \"morris\"\n"),
              IsEmpty());
}

TEST(Rules, KeysOfAWallBelongToItsLaw) {
  EXPECT_THAT(messages(smallest_case + "wall_friction_angle = 20\n"),
              ElementsAre("case.toml:11 numerics.wall_friction_angle: does not apply to wall = "
                          "\"no_slip\"; remove it, or choose wall = \"coulomb\" or \"voellmy\""));
  EXPECT_THAT(messages(smallest_case + "wall = \"coulomb\"\n"),
              ElementsAre("case.toml:8 numerics.wall_friction_angle: the wall has neither friction "
                          "nor cohesion; give an angle, or choose wall = \"slip\""));
  EXPECT_THAT(messages(smallest_case + "wall = \"voellmy\"\nwall_friction_angle = 10\n"),
              IsEmpty());
}

}  // namespace
}  // namespace sabo
