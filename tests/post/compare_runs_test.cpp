#include "post/compare_runs.hpp"

#include <fstream>

#include "post/made_run.hpp"
#include "post/map_difference.hpp"
#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/map_line.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

class CompareRuns : public testing::Test {
 protected:
  CompareRuns() {
    MadeRun run;
    run.depth = slab(4, 20, 4, 16);  // 8 x 6 cells, 192 m2
    run.write(folder_ / "with");
    run.depth = slab(4, 30, 4, 16);  // 13 x 6 cells, 312 m2
    run.speed = 5;
    run.quantities = "\"front run-out [m]\" = 22\n\"arrival at s [s]\" = 7\n";
    run.write(folder_ / "without");
  }
  TemporaryFolder folder_;
};

TEST_F(CompareRuns, ARunComparedWithItselfDoesNotDiffer) {
  compare_runs(folder_ / "with", folder_ / "with", folder_ / "same");
  for (const char* name : {"diff_dep", "diff_pfd", "diff_pfv"})
    for (const double value : map_of(folder_ / "same", name).values) ASSERT_EQ(value, 0) << name;
  EXPECT_THAT(file_text(folder_ / "same/tables/maps.csv"),
              HasSubstr("dep [m],1,1,0,0,0,192,0.000\n"));
  EXPECT_THAT(file_text(folder_ / "same/tables/quantities.csv"),
              HasSubstr("front run-out [m],12,12,0,0\n"));
}

TEST_F(CompareRuns, DifferencesAreBMinusAAndSwapTheirSigns) {
  compare_runs(folder_ / "with", folder_ / "without", folder_ / "ab");
  compare_runs(folder_ / "without", folder_ / "with", folder_ / "ba");
  for (const char* name : {"diff_dep", "diff_pfd", "diff_pfv", "diff_tarr"}) {
    const Raster ab = map_of(folder_ / "ab", name), ba = map_of(folder_ / "ba", name);
    for (std::size_t cell = 0; cell < ab.values.size(); ++cell)
      ASSERT_TRUE(ab.values[cell] == -ba.values[cell] ||
                  (std::isnan(ab.values[cell]) && std::isnan(ba.values[cell])))
          << name;
  }
  const Raster depth = map_of(folder_ / "ab", "diff_dep");
  EXPECT_EQ(depth.at(12, 5), 1) << "x = 25: reached without the dam only";
  EXPECT_TRUE(std::isnan(map_of(folder_ / "ab", "diff_tarr").at(12, 5)));
  EXPECT_EQ(map_of(folder_ / "ab", "reached").at(12, 5), 2);
  EXPECT_EQ(map_of(folder_ / "ab", "reached").at(5, 5), 3);
  // 5 x 6 cells of 4 m2 are 1 m deeper.
  EXPECT_THAT(file_text(folder_ / "ab/tables/maps.csv"), HasSubstr(",312,120.000\n"));
}

// A stretch of wall more than there are slits, and their label.
TEST_F(CompareRuns, ADamOfOneAloneIsDrawnWithAllItsParts) {
  const auto red_in = [&](const std::string& slit) {
    MadeRun run;
    run.keys =
        "[[structure]]\nname = \"dam\"\nline = [[25, 2], [25, 18]]\nheight = 3\nthickness = 2\n" +
        slit;
    run.write(folder_ / "dam");
    compare_runs(folder_ / "with", folder_ / "dam", folder_ / "drawn");
    const std::string svg = file_text(folder_ / "drawn/pictures/diff_dep.svg");
    std::size_t count = 0;
    const std::string red = style_of(MapLine::Kind::dam).colour;
    for (std::size_t k = svg.find(red); k != std::string::npos; k = svg.find(red, k + 1)) ++count;
    return count;
  };
  EXPECT_EQ(red_in("[[structure.slit]]\ncentre = 4\nwidth = 2\n"
                   "[[structure.slit]]\ncentre = 12\nwidth = 2\n"),
            red_in("") + 2);
}

TEST_F(CompareRuns, QuantitiesOfOneAloneAreKept) {
  const PostResult result = compare_runs(folder_ / "with", folder_ / "without", "");
  EXPECT_EQ(result.index, folder_ / "with/compare/index.html");
  const std::string table = file_text(folder_ / "with/compare/tables/quantities.csv");
  EXPECT_THAT(table, HasSubstr("front run-out [m],12,22,10,83.33\n"));
  EXPECT_THAT(table, HasSubstr("peak discharge at s [m3/s],4,-,-,-\n"));
  EXPECT_THAT(table, HasSubstr("arrival at s [s],-,7,-,-\n"));
  EXPECT_THAT(table, HasSubstr("dam peak force [N],5000,5000,0,0\n"));
  const std::string page = file_text(result.index);
  EXPECT_THAT(page, HasSubstr("pictures/front_02.svg"));
  EXPECT_THAT(page, Not(HasSubstr("not drawn"))) << "path and zone are known";
  EXPECT_THAT(file_text(folder_ / "with/compare/pictures/diff_dep.svg"), HasSubstr(">west</text>"));
}

TEST_F(CompareRuns, AnotherGridIsResampledAndThatIsSaid) {
  MadeRun run;
  run.grid = {10, 5, 0, 20, 4, 4};
  run.depth = slab(4, 20, 4, 16);
  run.write(folder_ / "coarse");
  compare_runs(folder_ / "with", folder_ / "coarse", folder_ / "out");
  const std::string page = file_text(folder_ / "out/index.html");
  EXPECT_THAT(page, HasSubstr("map dep of coarse was resampled from 4 x 4 m to 2 x 2 m cells"));
  EXPECT_EQ(map_of(folder_ / "out", "diff_dep").at(5, 5), 0) << "in the middle";
}

TEST_F(CompareRuns, SaysThatTheRunsEndAtDifferentTimes) {
  MadeRun run;
  run.simulated = 10.05;
  run.write(folder_ / "near");
  run.simulated = 7;
  run.write(folder_ / "short");
  EXPECT_THAT(compare_runs(folder_ / "with", folder_ / "near", folder_ / "out").summary,
              Not(testing::Contains(HasSubstr("different times"))));
  EXPECT_THAT(
      compare_runs(folder_ / "with", folder_ / "short", folder_ / "out").summary,
      testing::Contains("note: the runs end at different times, a at 10.0 s and b at 7.0 s"));
  EXPECT_THAT(file_text(folder_ / "out/index.html"), HasSubstr("end at different times"));
}

TEST_F(CompareRuns, RefusesAnotherCoordinateSystemAndFoldersOfOthers) {
  MadeRun run;
  run.crs = wkt_of_test_crs();
  run.write(folder_ / "utm");
  EXPECT_THAT(
      fault_of([&] { compare_runs(folder_ / "with", folder_ / "utm", folder_ / "out"); }).problem,
      HasSubstr("is in EPSG:32654"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  EXPECT_THAT(fault_of([&] { compare_runs(folder_ / "with", folder_ / "nowhere", ""); }).problem,
              HasSubstr("is not the folder of a run"));
  // Not into a run itself, nor into a folder with other files.
  EXPECT_THAT(fault_of([&] {
                compare_runs(folder_ / "with", folder_ / "without", folder_ / "without");
              }).problem,
              HasSubstr("holds files that are not those of this command"));
}

TEST_F(CompareRuns, WritesTwiceToOneFolder) {
  compare_runs(folder_ / "with", folder_ / "without", folder_ / "out");
  compare_runs(folder_ / "with", folder_ / "with", folder_ / "out");
  EXPECT_THAT(file_text(folder_ / "out/tables/maps.csv"),
              HasSubstr("dep [m],1,1,0,0,0,192,0.000\n"));
}

TEST(DifferenceSummary, AddsUpByHand) {
  Raster a({4, 1, 0, 1, 2, 1}), b = a;
  a.values = {0, 1, 0.01, Raster::no_data};
  b.values = {3, 0.5, 0.02, 4};
  const DifferenceSummary sum = summary_of(a, b, 0.05);
  EXPECT_EQ(sum.greatest_rise, 3);
  EXPECT_EQ(sum.greatest_fall, -0.5);
  EXPECT_DOUBLE_EQ(sum.integral, 2 * (3 - 0.5 + 0.01));
  EXPECT_EQ(sum.area, 4) << "two cells count";
  EXPECT_DOUBLE_EQ(sum.mean_absolute, 1.75);
  EXPECT_TRUE(std::isnan(shown_difference(a, b, 0.05).values[2]));
}

}  // namespace
}  // namespace sabo
