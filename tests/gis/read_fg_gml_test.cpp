#include "io/gis/read_fg_gml.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "gis/made_fg_gml.hpp"
#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/round_length.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

const char* const west_name = "FG-GML-6841-00-00-DEM5A-20161001.xml";
const char* const east_name = "FG-GML-6841-00-01-DEM5A-20210304.xml";

std::string values(const std::string& list) {
  std::string tuples;
  for (const char c : list) tuples += fmt::format("地表面,{}\n", c);
  return tuples;
}

class ReadFgGml : public testing::Test {
 protected:
  ReadFgGml() : folder_path_(folder_ / "dem") { std::filesystem::create_directories(folder_path_); }

  void write(const std::string& name, const MadeFgGml& made) {
    std::filesystem::create_directories((folder_path_ / name).parent_path());
    std::ofstream(folder_path_ / name) << made.text();
  }
  Fault fault(const std::filesystem::path& file) {
    return fault_of([&] { read_fg_gml(file); });
  }

  TemporaryFolder folder_;
  std::filesystem::path folder_path_;
  const MadeFgGml west_{.tuples = values("123456")};
  const MadeFgGml east_{
      .tuples = values("789"), .south_cells = 3, .west_cells = 3, .date = "2021-03-04"};
};

TEST_F(ReadFgGml, OneFileIsOneTile) {
  write(west_name, west_);
  const FgGmlDem dem = read_fg_gml(folder_path_ / west_name);
  EXPECT_THAT(dem.raster.values, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(dem.cell_size, 5);
  EXPECT_EQ(dem.note, "1 tile of 5 m, JGD2011, date 2016-10-01");
}

TEST_F(ReadFgGml, NeighboursInAFolderBecomeOneRaster) {
  write(west_name, west_);
  write("below/" + std::string(east_name), east_);  // one cell further south
  std::ofstream(folder_path_ / "fmdid15-3101.xml") << "<metadata/>";
  std::ofstream(folder_path_ / "._FG-GML-DEM5A.xml") << "of a Mac";
  const FgGmlDem dem = read_fg_gml(folder_path_);
  EXPECT_EQ(dem.raster.grid.columns, 6);
  EXPECT_EQ(dem.raster.grid.rows, 3);
  EXPECT_NEAR(dem.raster.grid.north, 45, 1e-9);
  EXPECT_THAT(dem.raster.values, ElementsAre(1, 2, 3, IsNan(), IsNan(), IsNan(),  //
                                             4, 5, 6, 7, 8, 9,                    //
                                             IsNan(), IsNan(), IsNan(), IsNan(), IsNan(), IsNan()));
  EXPECT_EQ(dem.note, "2 tiles of 5 m, JGD2011, dates 2016-10-01 to 2021-03-04");
}

TEST_F(ReadFgGml, AZipMayHoldFoldersAndZips) {
  write_into_zip(folder_ / "inner.zip", "deep/" + std::string(east_name), east_.text());
  write_into_zip(folder_ / "outer.zip", "PackDLMap/" + std::string(west_name), west_.text());
  write_into_zip(folder_ / "outer.zip", "PackDLMap/inner.zip", folder_.read("inner.zip"));
  EXPECT_EQ(read_fg_gml(folder_ / "outer.zip").raster.grid.columns, 6);
  std::filesystem::rename(folder_ / "outer.zip", folder_path_ / "outer.zip");
  EXPECT_EQ(read_fg_gml(folder_path_).raster.grid.columns, 6);
}

TEST_F(ReadFgGml, TheLaterFileNameCountsWhereItHasData) {
  write("FG-GML-6841-00-00-DEM5A-20210304.xml",
        {.tuples = "地表面,9\nデータなし,-9999.\n", .date = "2021-03-04"});
  write(west_name, west_);
  EXPECT_THAT(read_fg_gml(folder_path_).raster.values, ElementsAre(9, 2, 3, 4, 5, 6));
}

TEST_F(ReadFgGml, TheBetterSurveyCountsWhateverItsDate) {
  write("FG-GML-6841-00-00-DEM5C-20240101.xml", {.tuples = values("777777")});
  write("FG-GML-6841-00-00-dem5b-20230101.xml", {.tuples = values("88888")});
  write(west_name, {.tuples = values("1")});
  EXPECT_THAT(read_fg_gml(folder_path_).raster.values, ElementsAre(1, 8, 8, 8, 8, 7));
}

TEST_F(ReadFgGml, RefusesTilesThatDoNotBelongTogether) {
  write(west_name, west_);
  const auto refused = [&](const MadeFgGml& other) {
    write(east_name, other);
    return fault(folder_path_).problem;
  };
  EXPECT_THAT(refused({.srs = "fguuid:jgd2000.bl"}), HasSubstr("20210304.xml is in JGD2000, "));
  EXPECT_THAT(refused({.srs = "fguuid:jgd2024.bl"}), HasSubstr("20161001.xml in JGD2011"));
  EXPECT_THAT(refused({.seconds = 0.4}), HasSubstr("cells of 0.4 x 0.4 seconds"));
  EXPECT_THAT(refused({.west_cells = 3.5}), HasSubstr("does not lie on the grid of"));
  // Large enough that the rounding of its corners is no offset.
  write(west_name, {.south_cells = 300, .high = "299 299", .columns = 300, .rows = 300});
  EXPECT_THAT(refused({.south_cells = 200000,
                       .west_cells = -200000,
                       .high = "299 299",
                       .columns = 300,
                       .rows = 300}),
              HasSubstr("so far apart that 200300 x 200000 cells"));
}

TEST_F(ReadFgGml, SaysWhereThereIsNothingToRead) {
  EXPECT_THAT(fault(folder_path_).problem, HasSubstr("holds no DEM tile"));
  EXPECT_THAT(fault(folder_.write("a.zip", "no zip")).problem, HasSubstr("holds no DEM tile"));
  EXPECT_THAT(fault(folder_ / "none.xml").problem, HasSubstr("no such file"));
  EXPECT_THAT(fault(folder_.write("DEM.xml", "<a")).problem, HasSubstr("DEM.xml is no complete"));
}

TEST(FgGmlCodes, UtmZoneIsThatOfTheLongitude) {
  // EPSG: JGD2011 / UTM zone 51N to 55N are 6688 to 6692, JGD2000's 3097 to 3101.
  EXPECT_EQ(utm_code(JapaneseDatum::jgd2011, 123.0), 6688);
  EXPECT_EQ(utm_code(JapaneseDatum::jgd2011, 137.99), 6690);
  EXPECT_EQ(utm_code(JapaneseDatum::jgd2024, 138.0), 6691);
  EXPECT_EQ(utm_code(JapaneseDatum::jgd2000, 145.0), 3101);
  EXPECT_EQ(fault_of([] { utm_code(JapaneseDatum::jgd2011, 153.98); }).place, "terrain.crs");
}

TEST(RoundLength, IsTheNearestOfItsSeries) {
  // 0.04, 0.2, 0.4 seconds of a meridian; 1 and 3 seconds.
  EXPECT_DOUBLE_EQ(round_length(1.23), 1);
  EXPECT_DOUBLE_EQ(round_length(6.17), 5);
  EXPECT_DOUBLE_EQ(round_length(12.3), 10);
  EXPECT_DOUBLE_EQ(round_length(30.9), 30);
  EXPECT_DOUBLE_EQ(round_length(92.6), 100);
  EXPECT_DOUBLE_EQ(round_length(0.21), 0.2);
}

}  // namespace
}  // namespace sabo
