#include <algorithm>

#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "io/output/plan_file.hpp"
#include "run/finished_run.hpp"
#include "run/new_case.hpp"

namespace sabo {
namespace {

TEST(SceneRecord, ReleaseAndPlanAreKeptWithTheRun) {
  const TemporaryFolder folder;
  new_case("yohutagawa", folder / "case");
  const FinishedRun run = run_to_end(folder / "case", folder / "run",
                                     {{"numerics", "spacing", 3.0},
                                      {"numerics", "threads", std::int64_t{1}},
                                      {"run", "duration", 0.05}});
  // The example releases 8863 m3.
  EXPECT_NEAR(run.volume_of("maps/rel.tif"), 8863, 0.001 * 8863);
  const std::string manifest = run.text_of("manifest.toml");
  EXPECT_NE(manifest.find("[release]\nvolume = 8863\n"), std::string::npos);
  EXPECT_NE(manifest.find("\nmachine = \""), std::string::npos);

  const std::vector<MapLine> plan = read_plan(run.folder / "maps" / "plan.geojson");
  const auto dam = std::ranges::find(plan, MapLine::Kind::dam, &MapLine::kind);
  ASSERT_NE(dam, plan.end());
  EXPECT_EQ(dam->label, "dam");
  ASSERT_TRUE(dam->line.has_z);
  // In the coordinates of the DEM (UTM), at the elevation of the crest: 8 m above the ground.
  EXPECT_GT(dam->line.vertices[0].x, 350000);
  EXPECT_GT(dam->line.vertices[0].y, 3129000);
  EXPECT_NEAR(dam->line.vertices[0].z, 28.45, 0.5);
}

}  // namespace
}  // namespace sabo
