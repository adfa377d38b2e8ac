#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/key_text.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Faults of the smallest case with `from` replaced by `to`.
std::vector<std::string> replaced(const std::string& from, const std::string& to) {
  return messages(with(smallest_case, from, to));
}

std::vector<std::string> added(const std::string& text) { return messages(smallest_case + text); }

TEST(KeyFaults, SmallestCaseHasNone) { EXPECT_THAT(messages(smallest_case), IsEmpty()); }

TEST(KeyFaults, TextForANumber) {
  EXPECT_THAT(replaced("0.5", "\"0.75 m\""),
              ElementsAre("case.toml:9 numerics.spacing: found the text \"0.75 m\"; "
                          "give a number from 1e-6 to 10000 m"));
}

TEST(KeyFaults, OtherTypesForANumber) {
  EXPECT_THAT(replaced("0.5", "true"),
              ElementsAre(HasSubstr("spacing: found true; give a number")));
  EXPECT_THAT(replaced("0.5", "[1]"), ElementsAre(HasSubstr("spacing: found a list; give")));
  EXPECT_THAT(replaced("0.5", "{a = 1}"), ElementsAre(HasSubstr("spacing: found a table; give")));
  EXPECT_THAT(replaced("0.5", "2010-10-20"),
              ElementsAre(HasSubstr("spacing: found a date or time; give")));
}

TEST(KeyFaults, LongTextIsShortened) {
  const std::string ten = "ああああああああああ";  // 30 bytes
  EXPECT_THAT(replaced("0.5", "\"" + ten + ten + "\""),
              ElementsAre(HasSubstr("found the text \"" + ten + "あああ...\"")));
}

TEST(KeyFaults, OutOfRange) {
  EXPECT_THAT(replaced("0.5", "-3"),
              ElementsAre("case.toml:9 numerics.spacing: -3 is out of range; "
                          "give a number from 1e-6 to 10000 m"));
  EXPECT_THAT(replaced("volume = 100", "volume = 0"),
              ElementsAre("case.toml:5 release.volume: 0 is out of range; "
                          "give a number above 0, at most 1e12 m3"));
}

TEST(KeyFaults, NotFinite) {
  EXPECT_THAT(replaced("0.5", "nan"),
              ElementsAre("case.toml:9 numerics.spacing: nan is not a finite number; "
                          "give a number from 1e-6 to 10000 m"));
  EXPECT_THAT(replaced("0.5", "-inf"), ElementsAre(HasSubstr("-inf is not a finite number")));
}

TEST(KeyFaults, NotAWholeNumber) {
  EXPECT_THAT(added("threads = 1.5"), ElementsAre("case.toml:11 numerics.threads: found 1.5; "
                                                  "give a whole number from 0 to 1024"));
  EXPECT_THAT(added("threads = 9223372036854775807"), ElementsAre(HasSubstr("is out of range")));
}

TEST(KeyFaults, NotABool) {
  EXPECT_THAT(added("as_printed = \"yes\""),
              ElementsAre("case.toml:11 numerics.as_printed: found the text \"yes\"; "
                          "give true or false"));
}

TEST(KeyFaults, NotText) {
  EXPECT_THAT(messages("title = 3\n" + smallest_case),
              ElementsAre("case.toml:1 title: found 3; give text in quotes"));
}

TEST(KeyFaults, ControlCharactersAndLongTexts) {
  EXPECT_THAT(messages("title = \"a\\u0000b\"\n" + smallest_case),
              ElementsAre("case.toml:1 title: has a line break or a control character; remove it"));
  EXPECT_THAT(messages("note = \"" + std::string(1001, 'x') + "\"\n" + smallest_case),
              ElementsAre("case.toml:1 note: is longer than 1000 characters; shorten it"));
}

TEST(KeyFaults, UnknownWord) {
  EXPECT_THAT(added("boundary_stress = \"ownn\""),
              ElementsAre("case.toml:11 numerics.boundary_stress: \"ownn\" is not known; "
                          "give \"own\", \"mirror\" or \"none\""));
  EXPECT_THAT(added("method = 2"),
              ElementsAre("case.toml:11 numerics.method: found 2; give \"fast\" or \"paper\""));
}

TEST(KeyFaults, UnknownKeyWithTheNearestWord) {
  EXPECT_THAT(added("visocus_cfl = 0.1"),
              ElementsAre("case.toml:11 numerics.visocus_cfl: unknown key; "
                          "did you mean \"viscous_cfl\"?"));
  EXPECT_THAT(added("[strucure]"),
              ElementsAre("case.toml:11 strucure: unknown key; did you mean \"structure\"?"));
}

TEST(KeyFaults, UnknownKeyLikeNoOther) {
  EXPECT_THAT(replaced("[numerics]", "temperature = 20\n[numerics]"),
              ElementsAre("case.toml:8 run.temperature: unknown key; remove it, or use one of: "
                          "duration, output_interval, series_interval, checkpoint_interval, "
                          "kept_checkpoint_interval, stop_at_rest, rest_time, "
                          "rest_speed, rest_volume, rest_energy, rest_creep"));
}

TEST(KeyFaults, MissingKey) {
  EXPECT_THAT(replaced("spacing = 0.5", ""),
              ElementsAre("case.toml:8 numerics.spacing: is missing; "
                          "give a number from 1e-6 to 10000 m"));
}

TEST(KeyFaults, MissingTable) {
  EXPECT_THAT(replaced("[terrain]\ndem = \"dem.tif\"\n", ""),
              ElementsAre("case.toml terrain: has no ground; give one of dem and plane"));
}

TEST(KeyFaults, MissingKeysOfAListAndItsTable) {
  EXPECT_THAT(added("[[structure]]\nline = \"dam.gpkg\"\n[structure.notch]\ncentre = 1\nwidth = 1"),
              ElementsAre("case.toml:13 structure[1].notch.depth: is missing; "
                          "give a number above 0, at most 10000 m",
                          "case.toml:11 structure[1].thickness: is missing; give it, in m"));
}

TEST(KeyFaults, TablesOfTheWrongForm) {
  EXPECT_THAT(added("[section]\nline = \"path.gpkg\""),
              ElementsAre("case.toml:11 section: is not written as a table; "
                          "head its keys with [[section]]"));
  EXPECT_THAT(messages("section = [1]\n" + smallest_case),
              ElementsAre("case.toml:1 section: is not written as a table; "
                          "head its keys with [[section]]"));
  EXPECT_THAT(added("[[material]]"),
              ElementsAre("case.toml:11 material: is not written as a table; "
                          "head its keys with [material]"));
  EXPECT_THAT(added("[[structure]]\nline = \"dam.gpkg\"\nthickness = 1\nnotch = 3"),
              ElementsAre("case.toml:14 structure[1].notch: found 3; give a table"));
}

TEST(KeyFaults, NoSuchFile) {
  EXPECT_THAT(replaced("dem.tif", "dme.tif"),
              ElementsAre("case.toml:2 terrain.dem: there is no file " +
                          (folder_with_files() / "dme.tif").string() +
                          "; check the name; it starts at the folder of the case file"));
  EXPECT_THAT(replaced("dem.tif", ""),
              ElementsAre("case.toml:2 terrain.dem: the file name is empty; "
                          "give a file name or remove the key"));
}

TEST(KeyFaults, ListOfNumbers) {
  const auto crop = [](const std::string& value) {
    return replaced("[release]", "crop = " + value + "\n[release]");
  };
  const std::string wanted = "give [4 numbers], each from -1e8 to 1e8 m";
  EXPECT_THAT(crop("3"), ElementsAre("case.toml:3 terrain.crop: found 3; " + wanted));
  EXPECT_THAT(crop("[1, 2, 3]"),
              ElementsAre("case.toml:3 terrain.crop: found a list of 3; " + wanted));
  EXPECT_THAT(crop("[1, 2, \"3\", 4]"),
              ElementsAre("case.toml:3 terrain.crop: found the text \"3\" in the list; " + wanted));
  EXPECT_THAT(crop("[1, 2, 1e9, 4]"),
              ElementsAre("case.toml:3 terrain.crop: 1000000000 is out of range; " + wanted));
}

TEST(KeyFaults, Lines) {
  const auto section = [](const std::string& line) { return added("[[section]]\nline = " + line); };
  EXPECT_THAT(section("7"),
              ElementsAre("case.toml:12 section[1].line: found 7; give a file name in quotes or "
                          "points [[x, y], [x, y], ...]"));
  EXPECT_THAT(section("[[1, 2]]"), ElementsAre("case.toml:12 section[1].line: has fewer than two "
                                               "points; give two or more"));
  EXPECT_THAT(section("[[1, 2], [3]]"),
              ElementsAre("case.toml:12 section[1].line: point 2 is not [x, y] or [x, y, z]; "
                          "give numbers up to 1e8 m"));
  EXPECT_THAT(section("[[1, 2], [nan, 3]]"), ElementsAre(HasSubstr("point 2 is not")));
  EXPECT_THAT(section("[1, 2]"), ElementsAre(HasSubstr("point 1 is not")));
  EXPECT_THAT(section("[[1, 2], [3, 4, 5]]"),
              ElementsAre("case.toml:12 section[1].line: some points have z and some have not; "
                          "give z for all or for none"));
}

TEST(KeyFaults, UnknownRheologyWithoutFaultsThatFollowFromIt) {
  EXPECT_THAT(added("[material]\nrheology = \"cros\"\ntime_constant = 1\nnonsense_key = 2"),
              ElementsAre("case.toml:12 material.rheology: \"cros\" is not known; give " +
                              words_text(rheology_names()),
                          HasSubstr("case.toml:14 material.nonsense_key: unknown key; remove it")));
}

TEST(KeyFaults, KeyOfAnotherRheology) {
  EXPECT_THAT(added("[material]\nrheology = \"newtonian\"\ncohesion = 100"),
              ElementsAre("case.toml:13 material.cohesion: is no key of rheology \"newtonian\"; "
                          "remove it, or choose rheology = \"cross\", \"bingham\", "
                          "\"frigaard_nouar\", \"threshold\", \"papanastasiou\", "
                          "\"herschel_bulkley\", \"quadratic\" or \"mu_i\""));
  EXPECT_THAT(added("[material]\ntime_constant = 1"),
              ElementsAre("case.toml:12 material.time_constant: is no key of rheology \"cross\"; "
                          "remove it, or choose rheology = \"general_cross\""));
}

TEST(KeyFaults, TableWithoutAName) {
  for (const char* header : {"[=a]", "[[+]]", "[ #", "[.b]", "[&"})
    EXPECT_THAT(added(header), ElementsAre(HasSubstr("case.toml:11: not valid TOML"))) << header;
}

TEST(KeyFaults, DuplicateKey) {
  EXPECT_THAT(added("spacing = 1"),
              ElementsAre("case.toml:11: not valid TOML: error while parsing key-value pair: "
                          "cannot redefine existing floating-point 'spacing'; "
                          "give each key and each table once"));
}

TEST(KeyFaults, EightFaultsAtOnce) {
  EXPECT_EQ(messages(R"(titel = "a"
[terrain]
dem = "none.tif"
fill_holes = -1
[release]
polygon = "release.gpkg"
[material]
rheology = "bingham"
density = "heavy"
friction_angle = 61
[numerics]
spacing = inf
[run]
)")
                .size(),
            8u);
}

}  // namespace
}  // namespace sabo
