#include "post/compare_observed.hpp"

#include <fstream>

#include "post/made_run.hpp"
#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/gis/raster_file.hpp"
#include "io/gis/write_vectors.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

class CompareObserved : public testing::Test {
 protected:
  /// The run: 1 m deep over x 4 to 20, y 4 to 16, at last. The survey: 1.5 m over x 8 to 28.
  CompareObserved() {
    MadeRun run;
    run.depth = slab(4, 20, 4, 16);
    run.keys =
        "[observed]\noutline = [[8, 4], [28, 4], [28, 16], [8, 16]]\n"
        "source = \"flight <1>\"\n"
        "[[observed.arrival]]\nname = \"bridge\"\nplace = [15, 10]\ntime = 12\n"
        "[[observed.arrival]]\nname = \"church\"\nplace = [35, 10]\ntime = 30\n";
    run.write(folder_ / "run");
    Raster survey({20, 10, 0, 20, 2, 2}, Raster::no_data);
    for (int row = 2; row < 8; ++row)
      for (int column = 4; column < 14; ++column) survey.at(column, row) = 1.5;
    write_raster(folder_ / "survey.tif", survey, {});
  }
  TemporaryFolder folder_;
};

TEST_F(CompareObserved, ScoresTheSurveyOfTheCase) {
  const PostResult result = compare_observed(folder_ / "run", {}, "");
  const std::string scores = file_text(folder_ / "run/observed/tables/scores.csv");
  // 12 m wide: hit 8..20, miss 20..28, false 4..8.
  EXPECT_THAT(scores, HasSubstr("\nobserved area,240,m2\n"));
  EXPECT_THAT(scores, HasSubstr("\nhit,144,m2\nmiss,96,m2\nfalse alarm,48,m2\n"));
  EXPECT_THAT(scores, HasSubstr("intersection over union,0.5,\nprecision,0.75,\nrecall,0.6,\n"
                                "area ratio,0.8,\nOmega,0,\n"));
  // The path starts at x = 1; the farthest cells are at 27 and 19, the centroids at 18 and 12.
  EXPECT_THAT(scores, HasSubstr("\nobserved run-out along the path,26,m\n"
                                "simulated run-out along the path,18,m\nrun-out error,-8,m\n"
                                "centroid error along the path,-6,m\n"));
  EXPECT_THAT(scores, HasSubstr("distance between the centroids,6,m\n"));
  // The zone goes to x = 10: hit 8..10, false alarm 4..8.
  EXPECT_THAT(file_text(folder_ / "run/observed/tables/zones.csv"),
              HasSubstr("west,24,0,48,0.3333"));
  EXPECT_THAT(file_text(folder_ / "run/observed/tables/arrival.csv"),
              HasSubstr("bridge,12,15,3\nchurch,30,never,-\n"));
  EXPECT_THAT(file_text(result.index), HasSubstr("flight &lt;1&gt;"));
  const Raster cells = RasterFile(folder_ / "run/observed/maps/footprint.tif", "map").read();
  EXPECT_EQ(cells.at(5, 5), 1);
  EXPECT_EQ(cells.at(12, 5), 2);
  EXPECT_EQ(cells.at(2, 5), 3);
}

TEST_F(CompareObserved, ARasterHasDepths) {
  compare_observed(folder_ / "run", {folder_ / "survey.tif", "", {}}, folder_ / "out");
  const std::string scores = file_text(folder_ / "out/tables/scores.csv");
  EXPECT_THAT(scores, HasSubstr("\nhit,144,m2\n"));
  EXPECT_THAT(scores, HasSubstr("\nobserved volume,360,m3\nsimulated volume,192,m3\n"
                                "mean depth error where hit,-0.5,m\n"
                                "mean absolute depth error where hit,0.5,m\n"
                                "root mean square depth error where hit,0.5,m\n"));
  // Of the 100 m2 of the zone 24 are 1.5 m deep in the survey and 72 are 1 m deep in the run.
  EXPECT_THAT(file_text(folder_ / "out/tables/zones.csv"),
              HasSubstr("west,24,0,48,0.3333,0.18,0.36,-0.5,0.5\n"));
  const Raster error = RasterFile(folder_ / "out/maps/depth_error.tif", "map").read();
  EXPECT_EQ(error.at(12, 5), -1.5);
}

TEST_F(CompareObserved, TheThresholdAndTheMapCanBeChosen) {
  // The greatest depth is 2 m: above 1.2 m, as the survey is; the deposit of 1 m is not.
  compare_observed(folder_ / "run", {folder_ / "survey.tif", "peak_depth", 1.2}, folder_ / "peak");
  EXPECT_THAT(file_text(folder_ / "peak/tables/scores.csv"), HasSubstr("\nhit,144,m2\n"));
  compare_observed(folder_ / "run", {folder_ / "survey.tif", "deposit", 1.2}, folder_ / "end");
  EXPECT_THAT(file_text(folder_ / "end/tables/scores.csv"), HasSubstr("\nhit,0,m2\n"));
}

TEST_F(CompareObserved, OnlyTheSurveyedAreaIsCompared) {
  MadeRun run;
  run.depth = slab(4, 20, 4, 16);
  run.keys =
      "[observed]\noutline = [[8, 4], [28, 4], [28, 16], [8, 16]]\n"
      "within = [[10, 0], [40, 0], [40, 20], [10, 20]]\n";
  run.write(folder_ / "part");
  compare_observed(folder_ / "part", {}, folder_ / "out");
  EXPECT_THAT(file_text(folder_ / "out/tables/scores.csv"),
              HasSubstr("\nhit,120,m2\nmiss,96,m2\nfalse alarm,0,m2\n"));
}

TEST_F(CompareObserved, DepthErrorsAreThoseOfTheSurveyedArea) {
  MadeRun run;
  run.depth = slab(4, 20, 4, 16);
  run.keys =
      "[observed]\ndepth_raster = \"survey.tif\"\n"
      "within = [[10, 0], [40, 0], [40, 20], [10, 20]]\n";
  run.write(folder_ / "part");
  std::filesystem::copy(folder_ / "survey.tif", folder_ / "part/survey.tif");
  compare_observed(folder_ / "part", {}, folder_ / "out");
  const Raster error = map_of(folder_ / "out", "depth_error");
  EXPECT_EQ(error.at(12, 5), -1.5) << "x = 25: missed";
  EXPECT_TRUE(std::isnan(error.at(3, 5))) << "x = 7: 1 m that nobody looked for";
}

TEST_F(CompareObserved, RefusesWhatCannotBeCompared) {
  MadeRun run;
  run.write(folder_ / "bare");
  EXPECT_THAT(fault_of([&] { compare_observed(folder_ / "bare", {}, ""); }).problem,
              HasSubstr("no [observed]"));
  const auto problem = [&](const ObservedOptions& options) {
    return fault_of([&] { compare_observed(folder_ / "run", options, folder_ / "out"); }).problem;
  };
  EXPECT_THAT(problem({folder_ / "none.tif", "", {}}), HasSubstr("cannot be read as a raster"));
  EXPECT_THAT(problem({"", "speed", {}}), HasSubstr("\"speed\" is not known"));
  EXPECT_THAT(problem({"", "", -1.0}), HasSubstr("is not a depth"));
  write_polygons(folder_ / "away.gpkg", {{"", {{{{900, 0, 0}, {910, 0, 0}, {910, 9, 0}}}}}}, "");
  EXPECT_THAT(problem({folder_ / "away.gpkg", "", {}}), HasSubstr("nothing of it is wet"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace sabo
