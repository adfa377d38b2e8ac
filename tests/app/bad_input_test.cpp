// Wrong cases, files and run folders, as users have them: each is refused with exit code 2, with
// the place and what to do about it, in bounded time and memory, and leaves nothing outside its
// folder.

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;

struct WrongInput {
  const char* what;
  const char* make;    ///< shell, in a folder with a good case
  const char* answer;  ///< regular expression that the answer holds
  const char* command = "sabo check . --no-forecast";
};

/// A level square of 40 m at 100 m with cells of 1 m, 2 m of material on a part of it, a dam
/// beside.
constexpr const char* good_case = R"(
{ echo ncols 40; echo nrows 40; echo xllcorner 0; echo yllcorner 0; echo cellsize 1
  echo NODATA_value -9999; for row in $(seq 40); do echo $(for k in $(seq 40); do echo 100; done); done
} >dem.asc
cat >case.toml <<'END'
[terrain]
dem = "dem.asc"
assume_metres = true
[release]
polygon = [[10, 10], [16, 10], [16, 16], [10, 16]]
thickness = 2
[material]
density = 1800
[[structure]]
name = "dam"
line = [[25, 5], [25, 30]]
height = 4
thickness = 3
[[section]]
name = "gate"
line = [[20, 5], [20, 30]]
[[zone]]
name = "field"
polygon = [[30, 5], [35, 5], [35, 30], [30, 30]]
[numerics]
spacing = 1
[run]
duration = 0.1
END
)";

class BadInput : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    fs::create_directories(*folder_ / "good");
    const Outcome outcome = in("good", std::string(good_case) + "sabo check . --no-forecast");
    ASSERT_EQ(outcome.code, 0) << outcome.text;
  }
  static void TearDownTestSuite() { delete folder_; }

  static Outcome in(const std::string& name, const std::string& command) {
    return run_shell("cd '" + (*folder_ / name).string() + "' && { " + command + "\n}");
  }

  /// Each in a folder of its own.
  static void expect_refused(const std::vector<WrongInput>& inputs) {
    for (const WrongInput& input : inputs) {
      const fs::path place = *folder_ / "tried";
      fs::remove_all(place);
      fs::create_directories(place);
      fs::copy(*folder_ / "good", place / "case", fs::copy_options::recursive);
      // In a process of its own, so that the limits end with it.
      const Outcome outcome =
          in("tried/case", "{ " + std::string(input.make) +
                               "\n} && ulimit -v 3000000 && export OMP_NUM_THREADS=1 && sabo() { "
                               "timeout 20 \"" SABO_PROGRAM "\" \"$@\"; } && " +
                               input.command);
      EXPECT_EQ(outcome.code, 2) << input.what << ":\n" << outcome.text;
      EXPECT_THAT(outcome.text, ContainsRegex(input.answer)) << input.what;
      for (const fs::directory_entry& entry : fs::directory_iterator(place))
        EXPECT_TRUE(entry.path().filename().string().starts_with("case")) << input.what << entry;
    }
    std::printf("%zu wrong inputs tried\n", inputs.size());
  }

  static TemporaryFolder* folder_;
};
TemporaryFolder* BadInput::folder_ = nullptr;

TEST_F(BadInput, Terrain) {
  expect_refused({
      {"no file", "rm dem.asc", "terrain.dem.*there is no file"},
      {"an empty file", ": >dem.asc", "dem.asc"},
      {"a text", "echo hello >dem.asc", "dem.asc"},
      {"cut off in its header", "head -3 dem.asc >d; mv d dem.asc", "dem.asc"},
      {"cut off in its values", "head -20 dem.asc >d; mv d dem.asc", "dem.asc"},
      {"a folder", "rm dem.asc; mkdir dem.asc", "dem.asc"},
      {"random bytes", "head -c 5000 /dev/urandom >dem.asc", "dem.asc"},
      {"a link to itself", "rm dem.asc; ln -s dem.asc dem.asc", "dem.asc"},
      {"a link to nothing", "rm dem.asc; ln -s gone dem.asc", "there is no file"},
      {"a pipe without a writer", "rm dem.asc; mkfifo dem.asc", "dem.asc"},
      {"a device without an end", "sed -i 's#dem.asc#/dev/zero#' case.toml", "/dev/zero"},
      {"no data at all", "sed -i 's/\\b100\\b/-9999/g' dem.asc", "no data|without data|nodata"},
      {"one cell",
       "printf 'ncols 1\\nnrows 1\\nxllcorner 0\\nyllcorner 0\\ncellsize 1\\n5\\n' >dem.asc",
       "dem.asc|release"},
      {"more cells than there is memory for",
       "printf 'ncols 2000000\\nnrows 2000000\\nxllcorner 0\\nyllcorner 0\\ncellsize 1\\n5\\n' "
       ">dem.asc",
       "dem.asc"},
      {"columns below zero", "sed -i 's/ncols 40/ncols -40/' dem.asc", "dem.asc"},
      {"cells of no size", "sed -i 's/cellsize 1/cellsize 0/' dem.asc", "dem.asc"},
      {"elevations that are no numbers", "sed -i 's/^100 100/nan inf/' dem.asc", "dem.asc|terrain"},
      {"elevations beyond the Earth", "sed -i 's/^100 100/1e30 100/' dem.asc", "dem.asc|terrain"},
      {"neither metres nor a system", "sed -i '/assume_metres/d' case.toml", "assume_metres|crs"},
      {"an unknown system", "sed -i '/assume/a crs = \"EPSG:999999\"' case.toml", "crs"},
      {"a system in degrees", "sed -i '/assume/a crs = \"EPSG:4326\"' case.toml", "crs"},
      {"no terrain", "sed -i '/\\[terrain\\]/,+2d' case.toml", "terrain"},
      {"two terrains", "sed -i '/assume/a plane.extent = [0, 0, 40, 40]' case.toml", "plane"},
      {"a window beside it", "sed -i '/assume/a crop = [900, 900, 950, 950]' case.toml", "crop"},
      {"a window turned round", "sed -i '/assume/a crop = [30, 30, 10, 10]' case.toml", "crop"},
      {"cells too small for memory", "sed -i '/assume/a cell_size = 0.0001' case.toml",
       "cell_size"},
      {"an edit beside it",
       "printf '[[terrain.edit]]\\nkind = \"lower\"\\nby = 1\\npolygon = "
       "[[90,90],[95,90],[95,95]]\\n' "
       ">>case.toml",
       "edit"},
      {"an edit without an amount",
       "printf '[[terrain.edit]]\\nkind = \"lower\"\\npolygon = [[9,9],[15,9],[15,15]]\\n' "
       ">>case.toml",
       "by"},
      {"an edit of two points",
       "printf '[[terrain.edit]]\\nkind = \"lower\"\\nby = 1\\npolygon = [[9,9],[15,9]]\\n' "
       ">>case.toml",
       "polygon"},
  });
}

TEST_F(BadInput, Release) {
  const auto polygon = [](const char* points) {
    return "sed -i 's/^polygon = \\[\\[10, 10.*/polygon = " + std::string(points) + "/' case.toml";
  };
  const std::string outside = polygon("[[100, 100], [110, 100], [110, 110]]"),
                    line = polygon("[[10, 10], [20, 20]]"),
                    flat = polygon("[[10, 10], [12, 12], [14, 14]]"),
                    speck = polygon("[[10, 10], [10.01, 10], [10.01, 10.01]]"),
                    word = polygon("\"nowhere.gpkg\""), number = polygon("3"),
                    missing = polygon("[[10, 10], [nan, 10], [16, 16]]"),
                    in_dam = polygon("[[24, 10], [26, 10], [26, 20], [24, 20]]");
  expect_refused({
      {"beside the DEM", outside.c_str(), "release"},
      {"a line", line.c_str(), "release.polygon"},
      {"without an area", flat.c_str(), "release"},
      {"smaller than a particle", speck.c_str(), "release"},
      {"no file", word.c_str(), "there is no file"},
      {"a number", number.c_str(), "release.polygon"},
      {"a point that is none", missing.c_str(), "release.polygon"},
      {"within a dam", in_dam.c_str(), "release|dam"},
      {"on no data",
       "sed -i 's/^100.*/'\"$(yes -- -9999 | head -40 | tr '\\n' ' ')\"'/' dem.asc; sed -i "
       "'7s/-9999/100/g' "
       "dem.asc",
       "release"},
      {"no thickness", "sed -i '/^thickness = 2/d' case.toml", "release"},
      {"a thickness of nothing", "sed -i 's/^thickness = 2/thickness = 0/' case.toml", "thickness"},
      {"a volume of nothing", "sed -i 's/^thickness = 2/volume = 0/' case.toml", "volume"},
      {"a volume below nothing", "sed -i 's/^thickness = 2/volume = -5/' case.toml", "volume"},
      {"twice", "sed -i '/^thickness = 2/a box = [1, 1, 1, 2, 2, 2]' case.toml", "release"},
      {"none", "sed -i '/^\\[release\\]/,+2d' case.toml", "release"},
      {"an unknown raster",
       "sed -i '/^polygon = ..10/d;s/^thickness = 2/thickness_raster = \"a.tif\"/' "
       "case.toml",
       "a.tif"},
      {"a raster that is none",
       "echo x >a.tif; sed -i '/^polygon = ..10/d;s/^thickness = 2/thickness_raster = \"a.tif\"/' "
       "case.toml",
       "a.tif"},
      {"points that are words",
       "echo a b c >p.txt; sed -i '/^polygon = ..10/d;s/^thickness = 2/points = \"p.txt\"/' "
       "case.toml",
       "p.txt"},
      {"points of two numbers",
       "echo 1 2 >p.txt; sed -i '/^polygon = ..10/d;s/^thickness = 2/points = \"p.txt\"/' "
       "case.toml",
       "p.txt"},
      {"no points",
       ": >p.txt; sed -i '/^polygon = ..10/d;s/^thickness = 2/points = \"p.txt\"/' case.toml",
       "p.txt"},
      {"a vector file that is none",
       "echo x >r.gpkg; sed -i 's/^polygon = ..10.*/polygon = \"r.gpkg\"/' case.toml", "r.gpkg"},
      {"a GeoJSON without features",
       "echo '{\"type\":\"FeatureCollection\",\"features\":[]}' >r.geojson; "
       "sed -i 's/^polygon = ..10.*/polygon = \"r.geojson\"/' case.toml",
       "r.geojson"},
      {"a GeoJSON of points",
       "echo '{\"type\":\"Point\",\"coordinates\":[12,12]}' >r.geojson; "
       "sed -i 's/^polygon = ..10.*/polygon = \"r.geojson\"/' case.toml",
       "r.geojson"},
      {"a GeoJSON cut off",
       "echo '{\"type\":\"Polygon\",\"coordinates\":[[[1,' >r.geojson; "
       "sed -i 's/^polygon = ..10.*/polygon = \"r.geojson\"/' case.toml",
       "r.geojson"},
      {"too many particles", "sed -i 's/^spacing = 1/spacing = 0.0005/' case.toml", "spacing"},
  });
}

TEST_F(BadInput, StructuresAndMeasurements) {
  expect_refused({
      {"a dam of one point", "sed -i 's/^line = ..25.*/line = [[25, 5]]/' case.toml", "line"},
      {"a dam of no length", "sed -i 's/^line = ..25.*/line = [[25, 5], [25, 5]]/' case.toml",
       "line"},
      {"a dam beside the DEM", "sed -i 's/^line = ..25.*/line = [[95, 5], [95, 30]]/' case.toml",
       "dam|structure"},
      {"a dam without a height", "sed -i '/^height = 4/d' case.toml", "height|crest"},
      {"a dam of no height", "sed -i 's/^height = 4/height = 0/' case.toml", "height"},
      {"a dam of no thickness", "sed -i '/^thickness = 3/d' case.toml", "thickness"},
      {"a dam below zero", "sed -i 's/^thickness = 3/thickness = -3/' case.toml", "thickness"},
      {"a crest below the ground", "sed -i 's/^height = 4/crest = 50/' case.toml", "crest|ground"},
      {"a crest and a height", "sed -i '/^height = 4/a crest = 110' case.toml", "crest|height"},
      {"an unknown kind", "sed -i '/^height = 4/a kind = \"dyke\"' case.toml", "kind"},
      {"a notch beside the dam",
       "sed -i '/^thickness = 3/a notch = {centre = 90, width = 3, depth = 1}' case.toml", "notch"},
      {"a notch without its depth",
       "sed -i '/^thickness = 3/a notch = {centre = 10, width = 3}' case.toml", "notch.depth"},
      {"two of one name", "sed -n '/structure/,/^thickness = 3/p' case.toml >>case.toml", "dam"},
      {"a section of one point", "sed -i 's/^line = ..20.*/line = [[20, 5]]/' case.toml", "line"},
      {"a section beside the DEM",
       "sed -i 's/^line = ..20.*/line = [[120, 5], [120, 9]]/' case.toml", "section|gate"},
      {"a name of two lines", "sed -i 's/\"gate\"/\"ga\\\\nte\"/' case.toml", "name"},
      {"a zone beside the DEM",
       "sed -i 's/^polygon = ..30.*/polygon = [[90, 5], [95, 5], [95, 30]]/' case.toml",
       "zone|field"},
      {"a zone of a line", "sed -i 's/^polygon = ..30.*/polygon = [[30, 5], [35, 5]]/' case.toml",
       "polygon"},
      {"a gauge beside the DEM",
       "printf '[[gauge]]\\nname = \"g\"\\nplace = [90, 90]\\n' >>case.toml", "gauge|g"},
      {"a gauge without a place", "printf '[[gauge]]\\nname = \"g\"\\n' >>case.toml", "place"},
      {"a path of one point", "printf '[path]\\nline = [[1, 1]]\\n' >>case.toml", "path"},
      {"a path beside the DEM", "printf '[path]\\nline = [[91, 1], [95, 1]]\\n' >>case.toml",
       "path"},
      {"a body without a mesh", "printf '[[body]]\\nname = \"b\"\\nkind = \"mesh\"\\n' >>case.toml",
       "body"},
      {"a mesh that is none",
       "echo x >b.stl; printf '[[body]]\\nname = \"b\"\\nkind = \"mesh\"\\nfile = \"b.stl\"\\n' "
       ">>case.toml",
       "b.stl"},
      {"a mesh of one triangle",
       "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n' >b.obj; "
       "printf '[[body]]\\nname = \"b\"\\nkind = \"mesh\"\\nfile = \"b.obj\"\\n' >>case.toml",
       "b.obj"},
      {"a mesh with a corner that it has not",
       "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 9\\n' >b.obj; "
       "printf '[[body]]\\nname = \"b\"\\nkind = \"mesh\"\\nfile = \"b.obj\"\\n' >>case.toml",
       "b.obj"},
      {"a mesh that says it has four thousand million triangles",
       "{ head -c 80 /dev/zero; printf '\\377\\377\\377\\377'; } >b.stl; "
       "printf '[[body]]\\nname = \"b\"\\nkind = \"mesh\"\\nfile = \"b.stl\"\\n' >>case.toml",
       "b.stl"},
      {"a mesh of numbers that are none",
       "printf 'v 0 0 0\\nv nan 0 0\\nv 0 1 0\\nf 1 2 3\\n' >b.obj; "
       "printf '[[body]]\\nname = \"b\"\\nkind = \"mesh\"\\nfile = \"b.obj\"\\n' >>case.toml",
       "b.obj"},
  });
}

TEST_F(BadInput, CaseFiles) {
  expect_refused({
      {"none", "rm case.toml", "case.toml"},
      {"empty", ": >case.toml", "terrain"},
      {"no TOML", "echo '[[[' >case.toml", "case.toml:1"},
      {"cut off", "head -c 120 case.toml >c; mv c case.toml", "case.toml"},
      {"bytes that are no text", "head -c 3000 /dev/urandom >case.toml", "case.toml"},
      {"a zero byte", "printf 'title = \"a\\000b\"\\n' >case.toml", "case.toml"},
      {"a folder", "rm case.toml; mkdir case.toml", "case.toml"},
      {"a link to itself", "rm case.toml; ln -s case.toml case.toml", "case.toml"},
      {"a pipe without a writer", "rm case.toml; mkfifo case.toml", "case.toml"},
      {"a device without an end", ":", "/dev/zero", "sabo check /dev/zero"},
      {"larger than any case", "head -c 200000000 /dev/zero | tr '\\0' '#' >case.toml",
       "case.toml"},
      {"nested without end",
       "{ printf 'a = '; head -c 100000 /dev/zero | tr '\\0' '['; } >case.toml", "case.toml"},
      {"a key twice", "sed -i '/^spacing/a spacing = 2' case.toml", "case.toml:"},
      {"a table twice", "printf '[numerics]\\nspacing = 2\\n' >>case.toml", "case.toml:"},
      {"a date for a number", "sed -i 's/^spacing = 1/spacing = 2020-01-01/' case.toml", "spacing"},
      {"a unit", "sed -i 's/^spacing = 1/spacing = \"1 m\"/' case.toml", "spacing"},
      {"a comma for a point", "sed -i 's/^spacing = 1/spacing = 0,5/' case.toml", "case.toml:"},
      {"no spacing", "sed -i '/^spacing/d' case.toml", "spacing.*is missing"},
      {"no duration", "sed -i '/^duration/d' case.toml", "duration.*is missing"},
      {"a duration below zero", "sed -i 's/^duration.*/duration = -1/' case.toml", "duration"},
      {"an unknown law", "sed -i '/^density/a rheology = \"honey\"' case.toml", "rheology"},
      {"an unknown preset", "sed -i '/^density/a preset = \"mud\"' case.toml", "preset"},
      {"a friction angle of a wall", "sed -i '/^density/a friction_angle = 90' case.toml",
       "friction_angle"},
      {"a density of nothing", "sed -i 's/^density.*/density = 0/' case.toml", "density"},
      {"too much pore water", "sed -i '/^density/a pore_pressure_ratio = 1.5' case.toml",
       "pore_pressure_ratio"},
      {"no such case", ":", "nowhere", "sabo check nowhere"},
      {"no such case to run", ":", "nowhere", "sabo run nowhere"},
      {"a spacing of nothing on the command line", ":", "spacing", "sabo run . -o out --spacing 0"},
      {"a spacing that is none", ":", "spacing", "sabo run . -o out --spacing nan"},
      {"a duration that is none", ":", "duration", "sabo run . -o out --duration x"},
      {"an unknown method", ":", "method", "sabo run . -o out --method quick"},
      {"an unknown option", ":", "colour", "sabo run . --colour red"},
      {"an unknown command", ":", "rnu", "sabo rnu ."},
      {"results into a file", ": >out", "out.*is a file", "sabo run . -o out"},
      {"results among other files", "mkdir out; : >out/letter.txt", "out", "sabo run . -o out"},
      {"results in a folder that cannot be made", ":", "/proc/x", "sabo run . -o /proc/x"},
  });
}

TEST_F(BadInput, RunFolders) {
  const Outcome run = in("good", "OMP_NUM_THREADS=1 sabo run . -o run");
  ASSERT_EQ(run.code, 0) << run.text;
  expect_refused({
      {"none", ":", "nowhere", "sabo info nowhere"},
      {"a folder that is none", "mkdir x", "x", "sabo info x"},
      {"no manifest", "rm run/manifest.toml", "manifest|run", "sabo info run"},
      {"an empty manifest", ": >run/manifest.toml", "manifest|run", "sabo report run"},
      {"a manifest cut off", "head -c 40 run/manifest.toml >m; mv m run/manifest.toml",
       "manifest|run", "sabo report run"},
      {"a manifest of bytes", "head -c 4000 /dev/urandom >run/manifest.toml", "manifest|run",
       "sabo compare run run"},
      {"no maps", "rm -r run/maps", "maps", "sabo compare run run"},
      {"no frames", "rm -r run/frames", "frames|flow.pvd", "sabo plot run --times 0"},
      {"frames that are none", "echo x >run/frames/flow.pvd", "flow.pvd",
       "sabo plot run --times 0"},
      {"a frame that is gone", "rm run/frames/flow_*.vtp", "flow_", "sabo plot run --times 0"},
      {"a frame cut off", "for f in run/frames/flow_*.vtp; do head -c 900 $f >f; mv f $f; done",
       "flow_", "sabo plot run --times 0"},
      {"frames of bytes", "for f in run/frames/flow_*.vtp; do head -c 9000 /dev/urandom >$f; done",
       "flow_", "sabo plot run --times 0"},
      {"a time that is none", ":", "times", "sabo plot run --times x"},
      {"a map that is none", "echo x >run/maps/pfd.tif", "pfd", "sabo compare run run"},
      {"a survey that is gone", ":", "gone.tif", "sabo compare run --observed gone.tif"},
      {"no survey", ":", "observed|survey", "sabo compare run"},
      {"rules that are gone", ":", "gone.toml", "sabo hazard run --rules gone.toml"},
      {"rules that are none", "echo '[[[' >r.toml", "r.toml", "sabo hazard run --rules r.toml"},
      {"periods for other runs", ":", "periods", "sabo hazard run --periods 30,100"},
      {"an unknown format", ":", "format", "sabo export run --format shape"},
      {"a depth below zero", ":", "depths", "sabo export run --depths=-1"},
      {"an unknown language", ":", "language", "sabo report run --language xx"},
      {"another run that is none", "mkdir x", "x", "sabo report run --compare x"},
      {"the same run twice over", ":", "run", "sabo run . -o run"},
      {"a sweep over nothing", ":", "vary", "sabo sweep . --vary material.density="},
      {"a sweep over an unknown key", ":", "densty", "sabo sweep . --vary material.densty=1,2"},
      {"a sweep without an end", ":", "vary|step|values",
       "sabo sweep . --vary material.density=1:1e9:1e-9"},
      {"a study of no spacing", ":", "spacings", "sabo study . --spacings 0"},
  });
}

TEST_F(BadInput, CoordinateSystems) {
  const std::string to_utm =
      "sed -i 's/^assume_metres.*/crs = \"EPSG:32654\"/; "
      "s/^polygon = ..10.*/polygon = \"r.geojson\"/' case.toml; ";
  const auto polygon = [&](const char* system, const char* points) {
    return to_utm + "echo '{\"type\":\"FeatureCollection\"," + system +
           "\"features\":[{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":"
           "\"Polygon\",\"coordinates\":[" +
           points + "]}}]}' >r.geojson";
  };
  const std::string elsewhere = polygon("", "[[9,47],[9.001,47],[9.001,47.001],[9,47]]"),
                    swapped = polygon("", "[[36,141],[36,141.1],[36.1,141.1],[36,141]]"),
                    other_zone =
                        polygon("\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
                                "\"urn:ogc:def:crs:EPSG::32633\"}},",
                                "[[10,10],[16,10],[16,16],[10,10]]"),
                    beyond_the_pole = polygon("", "[[9,147],[9.001,147],[9.001,148],[9,147]]"),
                    crossed = polygon("\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
                                      "\"urn:ogc:def:crs:EPSG::32654\"}},",
                                      "[[10,10],[16,16],[16,10],[10,16],[10,10]]"),
                    hole_outside = polygon("\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
                                           "\"urn:ogc:def:crs:EPSG::32654\"}},",
                                           "[[10,10],[16,10],[16,16],[10,10]],"
                                           "[[20,20],[26,20],[26,26],[20,20]]");
  expect_refused({
      {"a release in degrees on another continent", elsewhere.c_str(), "release"},
      {"a release with latitude and longitude exchanged", swapped.c_str(), "release|r.geojson"},
      {"a release in another zone", other_zone.c_str(), "release"},
      {"a release beyond the pole", beyond_the_pole.c_str(), "release|r.geojson"},
      {"a release that crosses itself", crossed.c_str(), "release|r.geojson"},
      {"a hole outside of its ring", hole_outside.c_str(), "release|r.geojson"},
      {"a system of words", "sed -i 's/^assume_metres.*/crs = \"metres\"/' case.toml", "crs"},
      {"a system of nothing but its authority", "sed -i 's/^assume.*/crs = \"EPSG:\"/' case.toml",
       "crs"},
      {"a system of heights", "sed -i 's/^assume.*/crs = \"EPSG:5703\"/' case.toml", "crs"},
      {"a system in feet", "sed -i 's/^assume.*/crs = \"EPSG:2225\"/' case.toml", "crs"},
      {"a system centred on the Earth", "sed -i 's/^assume.*/crs = \"EPSG:4978\"/' case.toml",
       "crs"},
      {"a system beside a claim of metres", "sed -i '/^assume/a crs = \"EPSG:4326\"' case.toml",
       "crs"},
  });
}

TEST_F(BadInput, StructuresThatCannotStand) {
  const auto add = [](const std::string& text) {
    return "cat >>case.toml <<'END'\n" + text + "\nEND\n";
  };
  const auto wall = [&](const char* name, const char* line, const char* more) {
    return add(std::string("[[structure]]\nname = \"") + name + "\"\nline = " + line + "\n" + more);
  };
  const std::string across = wall("second", "[[15, 18], [35, 18]]", "height = 3\nthickness = 3"),
                    along = wall("second", "[[26, 5], [26, 30]]", "height = 3\nthickness = 3"),
                    loop = wall("loop", "[[30, 5], [35, 5], [35, 8], [32, 2]]",
                                "height = 3\nthickness = 1"),
                    through_release =
                        wall("second", "[[5, 13], [20, 13]]", "height = 3\nthickness = 3"),
                    slit_too_wide = "sed -i '/^thickness = 3/a slit = [{centre = 12, width = 90}]' "
                                    "case.toml",
                    two_notches = "sed -i '/^thickness = 3/a notch = [{centre = 12, width = 3, depth "
                                  "= 1}]' case.toml",
                    block = add("[[structure]]\nname = \"house\"\nkind = \"building\"\npolygon = "
                                "[[12, 12], [15, 12], [15, 15], [12, 15]]\nheight = 5"),
                    flat_block = add("[[structure]]\nname = \"house\"\nkind = \"building\"\npolygon "
                                     "= [[30, 32], [34, 32], [34, 36], [30, 36]]"),
                    bow = add("[[structure]]\nname = \"house\"\nkind = \"building\"\npolygon = "
                              "[[30, 32], [34, 36], [34, 32], [30, 36]]\nheight = 5");
  expect_refused({
      {"one across another", across.c_str(), "second|dam"},
      {"one within another", along.c_str(), "second|dam"},
      {"a wall that crosses itself", loop.c_str(), "loop"},
      {"a wall through the release", through_release.c_str(), "second|release"},
      {"a slit wider than its dam", slit_too_wide.c_str(), "slit"},
      {"a notch as a list", two_notches.c_str(), "notch"},
      {"a house in the release", block.c_str(), "house|release"},
      {"a house without a height", flat_block.c_str(), "height"},
      {"a house that crosses itself", bow.c_str(), "house|polygon"},
      {"a dam of a million points",
       "python3 -c \"print('[[structure]]\\nname = \\\"long\\\"\\nheight = 1\\nthickness = 1\\nline "
       "= [' + '[1, 1], ' * 50000 + ']')\" >>case.toml",
       "line|long|longer"},
  });
}

TEST_F(BadInput, Bodies) {
  const auto body = [](const std::string& mesh, const char* more = "") {
    return "cat >b.obj <<'END'\n" + mesh + "END\ncat >>case.toml <<'END'\n[[body]]\nname = " +
           "\"b\"\nkind = \"mesh\"\nfile = \"b.obj\"\n" + more + "\nEND\n";
  };
  const auto box = [](const char* keys) {
    return std::string("cat >>case.toml <<'END'\n[[body]]\nname = \"b\"\n") + keys + "\nEND\n";
  };
  const std::string tetrahedron =
      "v 30 30 100\nv 34 30 100\nv 30 34 100\nv 30 30 104\n"
      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::string open = body("v 30 30 100\nv 34 30 100\nv 30 34 100\nv 30 30 104\n"
                                "f 1 3 2\nf 1 2 4\nf 2 3 4\n"),
                    no_faces = body("v 0 0 0\nv 1 0 0\nv 0 1 0\n"),
                    flat = body("v 30 30 100\nv 34 30 100\nv 30 34 100\nf 1 2 3\nf 1 3 2\n"),
                    point = body("v 30 30 100\nf 1 1 1\n"), zero = body(tetrahedron, "scale = 0"),
                    endless = body(tetrahedron, "scale = 1e300"),
                    away = body(tetrahedron, "at = [1e6, 0, 0]"),
                    below = body("v 30 30 100\nv 31 30 100\nv 30 31 100\nf 1 2 -9\n"),
                    words = body("v a b c\nf 1 2 3\n"), empty = body(""),
                    in_release = body("v 11 11 99\nv 15 11 99\nv 11 15 99\nv 11 11 104\n"
                                      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"),
                    flipped = box("kind = \"box\"\nmin = [35, 35, 105]\nmax = [30, 30, 100]"),
                    no_size = box("kind = \"box\"\nmin = [30, 30, 100]\nmax = [30, 35, 105]"),
                    no_corner = box("kind = \"box\"\nmin = [30, 30, 100]"),
                    two_numbers = box("kind = \"box\"\nmin = [30, 30]\nmax = [35, 35]"),
                    shape = box("kind = \"sphere\"\nmin = [30, 30, 100]\nmax = [35, 35, 105]");
  expect_refused({
      {"an open mesh", open.c_str(), "b.obj|body"},
      {"a mesh without faces", no_faces.c_str(), "b.obj"},
      {"a mesh without a volume", flat.c_str(), "b.obj|body"},
      {"a mesh of a point", point.c_str(), "b.obj|body"},
      {"a mesh shrunk to nothing", zero.c_str(), "scale"},
      {"a mesh blown up", endless.c_str(), "scale"},
      {"a mesh beside the DEM", away.c_str(), "body|b"},
      {"a corner counted from the end beyond the first", below.c_str(), "b.obj"},
      {"corners of words", words.c_str(), "b.obj"},
      {"an empty mesh", empty.c_str(), "b.obj"},
      {"a mesh in the release", in_release.c_str(), "release|b"},
      {"a box turned round", flipped.c_str(), "min|max"},
      {"a box of no width", no_size.c_str(), "min|max"},
      {"a box of one corner", no_corner.c_str(), "max"},
      {"a box in plan", two_numbers.c_str(), "min|max"},
      {"an unknown shape", shape.c_str(), "kind"},
  });
}

TEST_F(BadInput, Inflows) {
  const auto inflow = [](const std::string& table, const char* line = "[[5, 10], [5, 20]]") {
    return "printf '" + table + "' >h.csv; cat >>case.toml <<'END'\n[[inflow]]\nname = \"i\"\n" +
           "line = " + line + "\nflows = \"right\"\nhydrograph = \"h.csv\"\nEND\n";
  };
  const std::string rows = "time,discharge\\n0,0\\n10,5\\n20,0\\n";
  const std::string empty = inflow(""), header = inflow("time,discharge\\n"),
                    words = inflow("time,discharge\\na,b\\n"),
                    back = inflow("time,discharge\\n0,1\\n10,5\\n5,0\\n"),
                    below = inflow("time,discharge\\n0,0\\n10,-5\\n20,0\\n"),
                    nothing = inflow("time,discharge\\n0,0\\n10,0\\n"),
                    nan = inflow("time,discharge\\n0,0\\n10,nan\\n"),
                    no_column = inflow("time,flow\\n0,0\\n10,4\\n"),
                    ragged = inflow("time,discharge\\n0,0\\n10\\n"),
                    flood = inflow("time,discharge\\n0,0\\n10,1e12\\n20,0\\n"),
                    beside = inflow(rows, "[[95, 10], [95, 20]]"),
                    point = inflow(rows, "[[5, 10]]"), gone = inflow(rows) + "rm h.csv",
                    in_dam = inflow(rows, "[[25, 10], [25, 20]]");
  expect_refused({
      {"an empty hydrograph", empty.c_str(), "h.csv|hydrograph"},
      {"a hydrograph of its header", header.c_str(), "h.csv|hydrograph"},
      {"a hydrograph of words", words.c_str(), "h.csv"},
      {"times that go back", back.c_str(), "h.csv"},
      {"a discharge below zero", below.c_str(), "h.csv"},
      {"a hydrograph of nothing", nothing.c_str(), "h.csv|hydrograph"},
      {"a discharge that is none", nan.c_str(), "h.csv"},
      {"a hydrograph without discharge", no_column.c_str(), "discharge"},
      {"a row cut short", ragged.c_str(), "h.csv"},
      {"a discharge beyond all rivers", flood.c_str(), "h.csv|inflow"},
      {"an inflow beside the DEM", beside.c_str(), "inflow|i"},
      {"an inflow through a point", point.c_str(), "line"},
      {"a hydrograph that is gone", gone.c_str(), "h.csv"},
      {"an inflow within a dam", in_dam.c_str(), "inflow|dam"},
  });
}

TEST_F(BadInput, Checkpoints) {
  const Outcome run = in("good", "OMP_NUM_THREADS=1 sabo run . -o run --overwrite");
  ASSERT_EQ(run.code, 0) << run.text;
  const char* const resume = "sabo run run --resume --duration 0.2";
  const char* const lost = "is lost|no checkpoint";
  expect_refused({
      {"none", "rm -r run/checkpoint", lost, resume},
      {"an empty one", "for f in run/checkpoint/*.sabo; do : >$f; done", lost, resume},
      {"cut off in its head", "truncate -s 10 run/checkpoint/*.sabo", lost, resume},
      {"cut off behind its head", "truncate -s 21 run/checkpoint/*.sabo", lost, resume},
      {"cut off in the middle", "truncate -s 2000 run/checkpoint/*.sabo", lost, resume},
      {"longer than it was", "for f in run/checkpoint/*.sabo; do echo x >>$f; done", lost, resume},
      {"of random bytes", "for f in run/checkpoint/*.sabo; do head -c 9000 /dev/urandom >$f; done",
       lost, resume},
      {"of zeros", "for f in run/checkpoint/*.sabo; do head -c 9000 /dev/zero >$f; done", lost,
       resume},
      {"of text", "for f in run/checkpoint/*.sabo; do echo checkpoint >$f; done", lost, resume},
      {"of another format",
       "for f in run/checkpoint/*.sabo; do printf '\\377' | dd of=$f bs=1 seek=16 conv=notrunc; "
       "done",
       lost, resume},
      {"a folder", "for f in run/checkpoint/*.sabo; do rm $f; mkdir $f; done", lost, resume},
      {"a link to itself", "for f in run/checkpoint/*.sabo; do rm $f; ln -s $f $f; done", lost,
       resume},
      {"a pipe without a writer", "for f in run/checkpoint/*.sabo; do rm $f; mkfifo $f; done", lost,
       resume},
      {"a device without an end",
       "for f in run/checkpoint/*.sabo; do ln -sf /dev/zero $f; done", lost, resume},
      {"larger than memory", "truncate -s 100G run/checkpoint/*.sabo", lost, resume},
      {"of another spacing", ":", "numerics.spacing", "sabo run run --resume --spacing 2"},
      {"of another material", "sed -i 's/1800/1900/' run/case.toml", "density", resume},
      {"of another DEM", "sed -i 's/^100 100/101 100/' dem.asc", "dem.asc", resume},
      {"of a DEM that is gone", "rm dem.asc", "dem.asc", resume},
      {"of another structure", "sed -i 's/height = 4/height = 5/' run/case.toml", "height", resume},
      {"of a run that has finished", ":", "has finished", "sabo run run --resume"},
      {"of a case that is gone", "rm run/case.toml", "case", resume},
      {"to be overwritten as well", ":", "overwrite|resume",
       "sabo run run --resume --overwrite"},
      {"to branch from, in no run", ":", "nowhere",
       "sabo run . -o out --branch-at 0.1 --from nowhere"},
      {"to branch from, before the first", ":", "no checkpoint",
       "sabo run . -o out --branch-at 0.001 --from run"},
      {"to branch from, at no time", ":", "branch", "sabo run . -o out --branch-at nan --from run"},
      {"to branch from, without a run", ":", "from", "sabo run . -o out --branch-at 0.1"},
      {"to branch from, without a time", ":", "branch", "sabo run . -o out --from run"},
      {"to branch from, with another spacing", ":", "spacing",
       "sabo run . -o out --branch-at 0.1 --from run --spacing 2"},
      {"to branch from into itself", ":", "run", "sabo run . -o run --branch-at 0.1 --from run"},
  });
}

// What looks odd and is not wrong.
TEST_F(BadInput, OddNamesAreRead) {
  for (const char* name : {"土石流 2010", "a 'b' \"c\"", "$(touch x)", "-o", "ünï—code", "a;b&c"}) {
    const fs::path place = *folder_ / "odd" / name;
    fs::remove_all(*folder_ / "odd");
    fs::create_directories(*folder_ / "odd");
    fs::copy(*folder_ / "good", place, fs::copy_options::recursive);
    fs::rename(place / "dem.asc", place / (std::string(name) + ".asc"));
    fs::create_symlink(std::string(name) + ".asc", place / "dem.asc");
    const Outcome outcome = in("odd", "for d in ./*; do sabo check \"$d\" --no-forecast; done");
    EXPECT_EQ(outcome.code, 0) << name << outcome.text;
  }
}

}  // namespace
}  // namespace sabo
