#include <string>

#include "app/bad_input.hpp"

// Wrong structures, bodies, inflows, and places of measurements.

namespace sabo {
namespace {

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

TEST_F(BadInput, StructuresThatCannotStand) {
  const auto add = [](const std::string& text) {
    return "cat >>case.toml <<'END'\n" + text + "\nEND\n";
  };
  const auto wall = [&](const char* name, const char* line, const char* more) {
    return add(std::string("[[structure]]\nname = \"") + name + "\"\nline = " + line + "\n" + more);
  };
  const std::string along = wall("second", "[[26, 5], [26, 30]]", "height = 3\nthickness = 3"),
                    loop = wall("loop", "[[30, 5], [35, 5], [35, 8], [32, 2]]",
                                "height = 3\nthickness = 1"),
                    slit_too_wide =
                        "sed -i '/^thickness = 3/a slit = [{centre = 12, width = 90}]' "
                        "case.toml",
                    two_notches =
                        "sed -i '/^thickness = 3/a notch = [{centre = 12, width = 3, depth "
                        "= 1}]' case.toml",
                    flat_block =
                        add("[[structure]]\nname = \"house\"\nkind = \"building\"\npolygon "
                            "= [[30, 32], [34, 32], [34, 36], [30, 36]]"),
                    bow =
                        add("[[structure]]\nname = \"house\"\nkind = \"building\"\npolygon = "
                            "[[30, 32], [34, 36], [34, 32], [30, 36]]\nheight = 5");
  expect_refused({
      {"one within another", along.c_str(), "second|dam"},
      {"a wall that crosses itself", loop.c_str(), "loop"},
      {"a slit wider than its dam", slit_too_wide.c_str(), "slit"},
      {"a notch as a list", two_notches.c_str(), "notch"},
      {"a house without a height", flat_block.c_str(), "height"},
      {"a house that crosses itself", bow.c_str(), "house|polygon"},
      {"a dam of a million points",
       "python3 -c \"print('[[structure]]\\nname = \\\"long\\\"\\nheight = 1\\nthickness = "
       "1\\nline "
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
  const std::string open = body(
                        "v 30 30 100\nv 34 30 100\nv 30 34 100\nv 30 30 104\n"
                        "f 1 3 2\nf 1 2 4\nf 2 3 4\n"),
                    no_faces = body("v 0 0 0\nv 1 0 0\nv 0 1 0\n"),
                    flat = body("v 30 30 100\nv 34 30 100\nv 30 34 100\nf 1 2 3\nf 1 3 2\n"),
                    point = body("v 30 30 100\nf 1 1 1\n"), zero = body(tetrahedron, "scale = 0"),
                    endless = body(tetrahedron, "scale = 1e300"),
                    away = body(tetrahedron, "at = [1e6, 0, 0]"),
                    below = body("v 30 30 100\nv 31 30 100\nv 30 31 100\nf 1 2 -9\n"),
                    words = body("v a b c\nf 1 2 3\n"), empty = body(""),
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

}  // namespace
}  // namespace sabo
