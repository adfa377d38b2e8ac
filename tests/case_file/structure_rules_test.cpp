#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Faults of the smallest case with one structure, whose keys start at line 12.
std::vector<std::string> structure(const std::string& keys) {
  return messages(smallest_case + "[[structure]]\n" + keys);
}

/// Of a dam along x from 0 to 20, 5 m high, with other tables after it from line 15.
std::vector<std::string> check_dam(const std::string& tables) {
  return structure("line = [[0, 0], [20, 0]]\nheight = 5\nthickness = 2\n" + tables);
}

TEST(StructureRules, EachKindHasItsKeys) {
  EXPECT_THAT(structure("kind = \"deflection_wall\"\nline = [[0, 0], [9, 0]]\nheight = 3\n"
                        "thickness = 1\n"),
              IsEmpty());
  EXPECT_THAT(structure("kind = \"building\"\npolygon = [[0, 0], [9, 0], [9, 9]]\nheight = 3\n"),
              IsEmpty());
  EXPECT_THAT(
      structure("kind = \"building\"\npolygon = \"release.gpkg\"\nheight_attribute = \"h\"\n"),
      IsEmpty());
  EXPECT_THAT(structure("kind = \"building\"\nline = \"dam.gpkg\"\nthickness = 2\nheight = 3\n"),
              ElementsAre("case.toml:13 structure[1].line: does not apply to kind \"building\"; "
                          "remove it",
                          "case.toml:11 structure[1].polygon: is missing; give a vector file or "
                          "coordinates",
                          "case.toml:14 structure[1].thickness: does not apply to kind "
                          "\"building\"; remove it"));
  EXPECT_THAT(structure("kind = \"deflection_wall\"\nline = [[0, 0], [9, 0]]\nheight = 3\n"
                        "thickness = 1\n[[structure.slit]]\ncentre = 3\nwidth = 1\n"),
              ElementsAre("case.toml:16 structure[1].slit: does not apply to kind "
                          "\"deflection_wall\"; remove it"));
  EXPECT_THAT(structure("height = 3\n"),
              ElementsAre("case.toml:11 structure[1].line: is missing; give a vector file or "
                          "coordinates",
                          "case.toml:11 structure[1].thickness: is missing; give it, in m"));
}

TEST(StructureRules, ABuildingHasOneHeight) {
  const std::string outline = "kind = \"building\"\npolygon = [[0, 0], [9, 0], [9, 9]]\n";
  EXPECT_THAT(structure(outline), ElementsAre("case.toml:11 structure[1]: has no height; give "
                                              "height or height_attribute"));
  EXPECT_THAT(structure(outline + "height = 3\nheight_attribute = \"h\"\n"),
              ElementsAre("case.toml:15 structure[1].height_attribute: a polygon given by "
                          "coordinates has no attributes; give height",
                          "case.toml:11 structure[1]: has a height and a height_attribute; give "
                          "one of the two"));
}

TEST(StructureRules, OpeningsLieInTheDamAndBelowItsCrest) {
  EXPECT_THAT(
      check_dam("[[structure.slit]]\ncentre = 1\nwidth = 2\n[[structure.slit]]\ncentre = 10\n"
                "width = 4\nsill = 2\nheight = 1.5\n"),
      IsEmpty());
  EXPECT_THAT(check_dam("[[structure.slit]]\ncentre = 0.9\nwidth = 2\n"),
              ElementsAre("case.toml:16 structure[1].slit[1].centre: reaches beyond the start of "
                          "the line; move it, or make it narrower"));
  EXPECT_THAT(check_dam("[[structure.slit]]\ncentre = 19.5\nwidth = 2\n"),
              ElementsAre("case.toml:16 structure[1].slit[1].centre: reaches beyond the end of the "
                          "line; give distances along the line, at most 20 m"));
  EXPECT_THAT(check_dam("[[structure.slit]]\ncentre = 9\nwidth = 2\nsill = 5\n"),
              ElementsAre("case.toml:18 structure[1].slit[1].sill: is not below the crest; give "
                          "less than 5 m"));
  EXPECT_THAT(
      check_dam("[[structure.slit]]\ncentre = 9\nwidth = 2\nsill = 1\nsill_elevation = 3\n"),
      ElementsAre("case.toml:15 structure[1].slit[1]: has a sill and a sill_elevation; "
                  "give one of the two"));
  EXPECT_THAT(check_dam("[[structure.slit]]\ncentre = 9\nwidth = -2\n"),
              ElementsAre("case.toml:17 structure[1].slit[1].width: -2 is out of range; give a "
                          "number above 0, at most 100000 m"));
  EXPECT_THAT(check_dam("[[structure.slit]]\ncentre = 9\nwith = 2\n"),
              ElementsAre("case.toml:15 structure[1].slit[1].width: is missing; give a number "
                          "above 0, at most 100000 m",
                          "case.toml:17 structure[1].slit[1].with: unknown key; did you mean "
                          "\"width\"?"));
}

TEST(StructureRules, AGridHasAPostAndBeamsOfAHeight) {
  const std::string grid = "[[structure.grid]]\nfrom = 5\npost_width = 1\n";
  EXPECT_THAT(
      check_dam(grid + "to = 15\ngap = 2\npost_depth = 2\nbeam_gap = 1\nbeam_height = 0.5\n"),
      IsEmpty());
  EXPECT_THAT(check_dam(grid + "to = 9\ngap = 2\n"),
              ElementsAre("case.toml:15 structure[1].grid[1]: is 4 m long, which has no room for "
                          "a post and a gap on each side of it; give 5 m or more, or a slit"));
  EXPECT_THAT(check_dam(grid + "to = 4\ngap = 2\n"),
              ElementsAre("case.toml:18 structure[1].grid[1].to: is not beyond from; give a "
                          "stretch of some length"));
  EXPECT_THAT(check_dam(grid + "to = 25\ngap = 2\n"),
              ElementsAre("case.toml:18 structure[1].grid[1].to: reaches beyond the end of the "
                          "line; give distances along the line, at most 20 m"));
  EXPECT_THAT(check_dam(grid + "to = 15\ngap = 2\npost_depth = 3\nbeam_gap = 1\n"),
              ElementsAre("case.toml:20 structure[1].grid[1].post_depth: is more than the "
                          "thickness of the dam; give at most 2 m",
                          "case.toml:21 structure[1].grid[1].beam_gap: is one of a pair; give "
                          "beam_height too"));
}

}  // namespace
}  // namespace sabo
