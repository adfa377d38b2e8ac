#include "app/bad_input.hpp"

#include <string>

// Wrong cases, DEMs and releases.

namespace sabo {
namespace {

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
                    other_zone = polygon(
                        "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
                        "\"urn:ogc:def:crs:EPSG::32633\"}},",
                        "[[10,10],[16,10],[16,16],[10,10]]"),
                    beyond_the_pole = polygon("", "[[9,147],[9.001,147],[9.001,148],[9,147]]"),
                    crossed = polygon(
                        "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
                        "\"urn:ogc:def:crs:EPSG::32654\"}},",
                        "[[10,10],[16,16],[16,10],[10,16],[10,10]]"),
                    hole_outside = polygon(
                        "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
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
      {"a density in tonnes", "sed -i 's/^density.*/density = 1.8/' case.toml",
       "density.*from 100 to 30000 kg/m3"},
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

}  // namespace
}  // namespace sabo
