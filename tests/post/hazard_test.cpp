#include "post/hazard.hpp"

#include <fstream>

#include "post/made_run.hpp"
#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/gis/read_vectors.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

class Hazard : public testing::Test {
 protected:
  /// Often a small flow, 2 m deep at most and slow; seldom a fast one that goes farther.
  Hazard() {
    MadeRun run;
    run.depth = slab(4, 20, 4, 16);
    run.speed = 0.5;
    run.write(folder_ / "often");
    run.depth = slab(10, 30, 4, 16);
    run.speed = 3;
    run.write(folder_ / "seldom");
  }
  TemporaryFolder folder_;
};

TEST_F(Hazard, ClassesOfOneRun) {
  const PostResult result = hazard_maps({{folder_ / "seldom"}, "swiss", {}, ""});
  const auto out = folder_ / "seldom/hazard";
  EXPECT_EQ(map_of(out, "classes").at(7, 5), 2) << "2 m and 3 m/s: strong";
  EXPECT_TRUE(std::isnan(map_of(out, "classes").at(3, 5)));
  EXPECT_THAT(file_text(out / "tables/classes.csv"), HasSubstr("strong,2,240\nmedium,1,0\n"));
  EXPECT_FALSE(std::filesystem::exists(out / "maps/levels.tif"));
  const auto polygons = read_valued_polygons(out / "maps/classes.gpkg", "", "key", "area_m2");
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].value, 240);
  EXPECT_EQ(file_text(out / "rules.toml"), hazard_rules_of("swiss"));
  EXPECT_THAT(file_text(result.index), HasSubstr("BUWAL")) << "the source";
  EXPECT_THAT(file_text(result.index), HasSubstr("check the diagram of your canton"));
}

TEST_F(Hazard, LevelsOfSeveralRunsAreTheWorst) {
  hazard_maps({{folder_ / "often", folder_ / "seldom"}, "swiss", {30, 300}, folder_ / "out"});
  const Raster classes = map_of(folder_ / "out", "classes");
  const Raster levels = map_of(folder_ / "out", "levels");
  // Levels: 3 red, 2 blue, 1 residual. Medium in 30 years is red, strong in 300 too.
  EXPECT_EQ(classes.at(3, 5), 1) << "x = 7: the slow flow alone";
  EXPECT_EQ(levels.at(3, 5), 3);
  EXPECT_EQ(classes.at(12, 5), 2) << "x = 25: the fast flow alone";
  EXPECT_EQ(levels.at(12, 5), 3);
  hazard_maps({{folder_ / "often"}, "swiss", {100}, folder_ / "blue"});
  EXPECT_EQ(map_of(folder_ / "blue", "levels").at(3, 5), 2);
}

TEST_F(Hazard, ImpactTakesTheDensityOfTheCase) {
  // 2000 kg/m3 at 3 m/s: 18 kPa, over the 4.9 kPa that a house stands 2 m deep.
  hazard_maps({{folder_ / "seldom"}, "japan", {}, folder_ / "fast"});
  EXPECT_EQ(map_of(folder_ / "fast", "classes").at(12, 5), 2) << "red";
  // At 0.5 m/s: 0.5 kPa.
  hazard_maps({{folder_ / "often"}, "japan", {}, folder_ / "slow"});
  EXPECT_EQ(map_of(folder_ / "slow", "classes").at(5, 5), 1) << "reached";
}

TEST_F(Hazard, RulesMayBeAFile) {
  std::ofstream(folder_ / "my.toml")
      << "name = \"my <rules>\"\nsource = \"me\"\nwet_depth = 1.5\n[[class]]\nname = \"any\"\n"
         "colour = \"#112233\"\n";
  hazard_maps({{folder_ / "often"}, folder_ / "my.toml", {}, folder_ / "out"});
  EXPECT_THAT(file_text(folder_ / "out/tables/classes.csv"), HasSubstr("any,1,192\n"));
  EXPECT_THAT(file_text(folder_ / "out/index.html"), HasSubstr("my &lt;rules&gt;"));
}

TEST_F(Hazard, RefusesARunWhoseCaseCannotBeRead) {
  std::ofstream(folder_ / "often/case.toml") << "numerics = ";
  EXPECT_THROW(hazard_maps({{folder_ / "often"}, "swiss", {}, folder_ / "out"}), CaseError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(Hazard, RefusesWhatDoesNotFit) {
  const auto problem = [&](const HazardOptions& options) {
    return fault_of([&] { hazard_maps(options); }).problem;
  };
  EXPECT_THAT(problem({{folder_ / "often"}, "swis", {}, ""}),
              HasSubstr("neither rules of the program nor a file"));
  EXPECT_THAT(problem({{folder_ / "often"}, "swiss", {30, 100}, ""}),
              HasSubstr("2 return periods for 1 run"));
  EXPECT_THAT(problem({{folder_ / "often"}, "japan", {30}, ""}), HasSubstr("have no matrix"));
  EXPECT_THAT(problem({{folder_ / "often", folder_ / "." / "often"}, "japan", {}, ""}),
              HasSubstr("is given twice"));
  EXPECT_THAT(problem({{folder_ / "often"}, "swiss", {0}, ""}), HasSubstr("no return period"));
  std::ofstream(folder_ / "flux.toml")
      << "name = \"a\"\nsource = \"b\"\n[[class]]\nname = \"c\"\ncolour = \"#112233\"\n"
         "when = [{ momentum_flux = 1 }]\n";
  EXPECT_THAT(problem({{folder_ / "often"}, folder_ / "flux.toml", {}, ""}),
              HasSubstr("has no map pmf.tif, which the rules look at (momentum_flux)"));
}

}  // namespace
}  // namespace sabo
