#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case/material_presets.hpp"
#include "io/case_file/write_case.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Case read_without_faults(const std::string& text, const std::vector<Override>& overrides = {}) {
  Faults faults;
  Case c = read_case_text(text, folder_with_files(), faults, overrides);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  return c;
}

TEST(ReadCase, SmallestCaseKeepsTheDefaults) {
  const Case c = read_without_faults(smallest_case);
  EXPECT_EQ(c.terrain.dem, folder_with_files() / "dem.tif");
  EXPECT_EQ(c.release.volume, 100.0);
  EXPECT_EQ(c.release.thickness, std::nullopt);
  EXPECT_EQ(c.numerics.spacing, 0.5);
  EXPECT_EQ(c.numerics.h_over_dp, NumericsCase{}.h_over_dp);
  EXPECT_EQ(c.run.duration, 10.0);
  EXPECT_EQ(name_of(c.material.law), "cross");
  EXPECT_EQ(c.folder, folder_with_files());
}

TEST(ReadCase, EveryKindOfValue) {
  const Case c = read_without_faults(smallest_case + R"(
threads = 2
reference_speed = 20
method = "paper"
viscous_operator = "morris"
as_printed = true
[material]
density = 1700.5
[[section]]
name = "p1"
line = [[1, 2], [3.5, -4], [1e3, 0]]
[[section]]
line = "path.gpkg"
[[structure]]
line = [[0, 0, 10], [20, 0, 11]]
thickness = 3
notch = { centre = 10, width = 4, depth = 1 }
)");
  EXPECT_EQ(c.numerics.threads, 2);
  EXPECT_EQ(c.numerics.reference_speed, 20.0);
  EXPECT_EQ(c.numerics.viscous_operator, ViscousOperator::morris);
  EXPECT_TRUE(c.numerics.as_printed);
  EXPECT_EQ(c.material.density, 1700.5);
  ASSERT_EQ(c.sections.size(), 2u);
  EXPECT_EQ(c.sections[0].name, "p1");
  EXPECT_FALSE(c.sections[0].line.has_z);
  EXPECT_THAT(c.sections[0].line.coordinates,
              ElementsAre(ElementsAre(1, 2, 0), ElementsAre(3.5, -4, 0), ElementsAre(1000, 0, 0)));
  EXPECT_EQ(c.sections[1].line.file, folder_with_files() / "path.gpkg");
  EXPECT_THAT(c.sections[1].line.coordinates, IsEmpty());
  ASSERT_EQ(c.structures.size(), 1u);
  EXPECT_TRUE(c.structures[0].line.has_z);
  EXPECT_EQ(c.structures[0].line.coordinates[1][2], 11.0);
  ASSERT_TRUE(c.structures[0].notch);
  EXPECT_EQ(c.structures[0].notch->width, 4.0);
}

TEST(ReadCase, ArrayOfNumbers) {
  const Case c =
      read_without_faults(with(smallest_case, "[release]", "crop = [0, 1, 2.5, 3]\n[release]"));
  ASSERT_TRUE(c.terrain.crop);
  EXPECT_THAT(*c.terrain.crop, ElementsAre(0, 1, 2.5, 3));
}

TEST(ReadCase, NamelessStructuresAndSectionsAreNumbered) {
  const Case c = read_without_faults(smallest_case + R"(
[[section]]
line = "path.gpkg"
[[section]]
name = "bridge"
line = "path.gpkg"
[[section]]
line = "path.gpkg"
[[structure]]
line = "dam.gpkg"
thickness = 3
)");
  EXPECT_EQ(c.sections[0].name, "section 1");
  EXPECT_EQ(c.sections[1].name, "bridge");
  EXPECT_EQ(c.sections[2].name, "section 3");
  EXPECT_EQ(c.structures[0].name, "structure 1");
}

TEST(ReadCase, KeysOfTheChosenRheology) {
  const Case bingham = read_without_faults(smallest_case + R"([material]
viscosity = 40
rheology = "bingham"
cohesion = 12
)");
  EXPECT_EQ(std::get<Bingham>(bingham.material.law).mu_b, 40);
  EXPECT_EQ(std::get<Bingham>(bingham.material.law).ratio, Bingham{}.ratio);
  EXPECT_EQ(bingham.material.yield.cohesion, 12);

  const Case water = read_without_faults(smallest_case + R"([material]
rheology = "newtonian"
)");
  EXPECT_EQ(std::get<Newtonian>(water.material.law).mu, Newtonian{}.mu);
}

TEST(ReadCase, ConcentrationGivesTheViscosityOfTheChosenLaw) {
  const Case c = read_without_faults(smallest_case + R"([material]
rheology = "papanastasiou"
concentration = 44
)");
  EXPECT_NEAR(std::get<Papanastasiou>(c.material.law).mu_b, 1255.86, 0.01);
}

TEST(ReadCase, PresetIsWhereTheOtherKeysStart) {
  const Case c = read_without_faults(smallest_case + R"([material]
preset = "mud_glenwood_4"
rheology = "bingham"  # its own: nothing changes
viscosity = 50
)");
  EXPECT_EQ(c.material.density, 1660);
  EXPECT_EQ(std::get<Bingham>(c.material.law).mu_b, 50);
  EXPECT_EQ(c.material.yield.cohesion, 22.9);

  const Case other = read_without_faults(smallest_case + R"([material]
preset = "mud_glenwood_4"
rheology = "papanastasiou"
)");
  EXPECT_EQ(std::get<Papanastasiou>(other.material.law).mu_b, 33.9) << "a viscosity is kept";
  EXPECT_EQ(other.material.yield.cohesion, 22.9);
}

TEST(ReadCase, EveryPresetReads) {
  for (const MaterialPreset& preset : material_presets()) {
    const Case c = read_without_faults(smallest_case + "[material]\npreset = \"" +
                                       std::string(preset.name) + "\"\n");
    EXPECT_EQ(c.material.density, preset.density) << preset.name;
    EXPECT_EQ(c.material.law.index(), preset.law.index()) << preset.name;
    // Written out and read back its values are within the ranges of their keys.
    Faults faults;
    const Case back = read_case_text(write_case(c), "/", faults);
    for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
    EXPECT_EQ(write_case(back), write_case(c)) << preset.name;
  }
}

TEST(ReadCase, EditsAndZonesGetNames) {
  const Case c = read_without_faults(smallest_case + R"([[terrain.edit]]
kind = "lower"
by = 1.5
polygon = [[0, 0], [1, 0], [1, 1]]
[[zone]]
polygon = "release.gpkg"
observed = 0.3
source = "survey"
)");
  ASSERT_EQ(c.terrain.edits.size(), 1u);
  EXPECT_EQ(c.terrain.edits[0].name, "edit 1");
  EXPECT_EQ(c.terrain.edits[0].kind, TerrainEditKind::lower);
  EXPECT_EQ(c.terrain.edits[0].by, 1.5);
  ASSERT_EQ(c.zones.size(), 1u);
  EXPECT_EQ(c.zones[0].name, "zone 1");
  EXPECT_EQ(c.zones[0].observed, 0.3);
}

TEST(ReadCase, OtherWaysOfTomlMeanTheSame) {
  const Case c = read_without_faults(
      "terrain.dem = \"dem.tif\"\r\n"
      "release = { polygon = \"release.gpkg\", volume = 1_00 }\r\n"
      "run.duration = 1e1\r\n"
      "numerics.spacing = 0.5 # comment\r\n");
  EXPECT_EQ(c.release.volume, 100.0);
  EXPECT_EQ(c.run.duration, 10.0);
}

TEST(ReadCase, CommandLineStandsInForTheFile) {
  const Case c = read_without_faults(with(smallest_case, "duration = 10\n", ""),
                                     {{"numerics", "spacing", 1.5},
                                      {"numerics", "threads", std::int64_t{2}},
                                      {"numerics", "backend", std::string("reference")},
                                      {"run", "duration", std::int64_t{20}}});
  EXPECT_EQ(c.numerics.spacing, 1.5);
  EXPECT_EQ(c.numerics.threads, 2);
  EXPECT_EQ(c.numerics.backend, BackendKind::reference);
  EXPECT_EQ(c.run.duration, 20.0);
}

TEST(ReadCase, CommandLineIsCheckedLikeTheFile) {
  Faults faults;
  read_case_text(smallest_case, folder_with_files(), faults, {{"numerics", "spacing", -1.0}});
  ASSERT_EQ(faults.list().size(), 1u);
  EXPECT_EQ(
      to_string(faults.list()[0]),
      "command line numerics.spacing: -1 is out of range; give a number from 1e-6 to 10000 m");
}

constexpr const char* two_dams = R"(
[[structure]]
line = [[0, 0, 10], [20, 0, 11]]
thickness = 3
notch = { centre = 10, width = 4, depth = 1 }
[[structure]]
line = [[0, 9, 10], [20, 9, 11]]
thickness = 3
)";

TEST(ReadCase, OverridesReachTablesWithinTables) {
  const Case c = read_without_faults(std::string(smallest_case) + two_dams,
                                     {{"structure[1].notch", "width", 5.5},
                                      {"structure[2]", "thickness", std::int64_t{4}},
                                      {"release", "normal", true}});
  EXPECT_EQ(c.structures[0].notch->width, 5.5);
  EXPECT_EQ(c.structures[0].thickness, 3.0);
  EXPECT_EQ(c.structures[1].thickness, 4.0);
  EXPECT_TRUE(c.release.normal);
}

// None of these may be passed over, or set something else.
TEST(ReadCase, OverridesOfNoTableAreFaults) {
  for (const char* table : {"structure", "structure[3]", "structure[0]", "structure[1",
                            "structure[1]x", "structure[1].slit[1]", "structure[x]", "body[1]"}) {
    Faults faults;
    read_case_text(std::string(smallest_case) + two_dams, folder_with_files(), faults,
                   {{table, "thickness", 5.0}});
    EXPECT_FALSE(faults.list().empty()) << table;
  }
}

TEST(ReadCase, WhatTheCommandLineLacksIsMissedInTheFile) {
  Faults faults;
  read_case_text(with(smallest_case, "[numerics]\nspacing = 0.5\n", ""), folder_with_files(),
                 faults, {{"numerics", "threads", std::int64_t{1}}});
  ASSERT_EQ(faults.list().size(), 1u);
  EXPECT_EQ(to_string(faults.list()[0]),
            "case.toml numerics.spacing: is missing; give a number from 1e-6 to 10000 m");
}

TEST(ReadCase, FromAFileOrItsFolderWithSpacesAndUnicodeInTheirNames) {
  const TemporaryFolder folder("与兵 沢 é");
  folder.write("地形 1.tif");
  folder.write("release.gpkg");
  const auto file = folder.write("case.toml", with(smallest_case, "dem.tif", "地形 1.tif"));
  for (const auto& given : {file, folder.path()}) {
    Faults faults;
    const Case c = read_case(given, faults);
    EXPECT_TRUE(faults.empty());
    EXPECT_EQ(c.terrain.dem, folder.path() / "地形 1.tif");
    EXPECT_EQ(c.folder, folder.path());
  }
}

TEST(ReadCase, PathsMayLeaveTheFolder) {
  const TemporaryFolder folder;
  folder.write("dem.tif");
  folder.write("release.gpkg");
  std::filesystem::create_directory(folder.path() / "runs");
  const std::string text = with(with(smallest_case, "dem.tif", "../dem.tif"), "release.gpkg",
                                (folder.path() / "release.gpkg").string());
  Faults faults;
  const Case c = read_case_text(text, folder.path() / "runs", faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(c.terrain.dem, folder.path() / "dem.tif");
  EXPECT_EQ(c.release.polygon.file, folder.path() / "release.gpkg");
}

TEST(ReadCase, FilesOfAFormerRunMayBeGone) {
  Faults faults;
  const Case c = read_former_case(with(smallest_case, "dem.tif", "/gone/dem.tif"), "/gone", faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(c.terrain.dem, "/gone/dem.tif");
  EXPECT_EQ(c.release.polygon.file, "/gone/release.gpkg");
}

TEST(ReadCase, NoSuchFile) {
  const TemporaryFolder folder;
  Faults faults;
  read_case(folder.path(), faults);
  ASSERT_EQ(faults.list().size(), 1u);
  EXPECT_EQ(to_string(faults.list()[0]), folder.path().string() + ": cannot open " +
                                             (folder.path() / "case.toml").string() +
                                             "; give a case file, or a folder with a case.toml");
}

}  // namespace
}  // namespace sabo
