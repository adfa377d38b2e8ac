#include "run/avaframe.hpp"

#include <filesystem>

#include "gis/made_raster.hpp"
#include "support/fault_of.hpp"
#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/finished_run.hpp"
#include "run/load_case.hpp"
#include "run/preview.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(AvaFrame, OtherFoldersAreNone) {
  const TemporaryFolder folder;
  EXPECT_FALSE(avaframe_case(folder / ""));
  EXPECT_FALSE(avaframe_case(folder / "nothing"));
  fs::create_directory(folder / "REL");
  EXPECT_FALSE(avaframe_case(folder / "")) << "REL is empty";
  folder.write("REL/a.shp", "");
  folder.write("case.toml", "");
  EXPECT_FALSE(avaframe_case(folder / "")) << "a case of its own comes first";
}

TEST(AvaFrame, AProjectNeedsOneDem) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "Inputs" / "REL");
  folder.write("Inputs/REL/a.shp", "");
  const Fault fault = fault_of([&] { avaframe_case(folder / ""); });
  EXPECT_THAT(fault.problem, HasSubstr("has REL/ as an AvaFrame project, and 0 rasters"));
}

// Its keys must go together, whatever the files hold.
TEST(AvaFrame, TheCaseThatIsMadeHasNoFaultsOfItsOwn) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "Inputs" / "REL");
  folder.write("Inputs/REL/a.shp", "");
  MadeRaster{}.write(folder / "Inputs" / "dem.tif");
  Faults faults;
  const Case c = load_case(folder / "", faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  EXPECT_EQ(c.release.polygon.file.filename(), "a.shp");
}

TEST(AvaFrame, KotRunsAsItIs) {
  const fs::path data = data_folder() / "terrain" / "avakot_5m";
  if (!fs::exists(data)) GTEST_SKIP() << "no data: set SABO_DATA";
  Faults faults;
  const Case c =
      load_case(data, faults, {{"run", "duration", 0.1}, {"numerics", "threads", std::int64_t{1}}});
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  const Scene scene = make_scene(c, faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  ASSERT_EQ(scene.dams.size(), 1u);
  EXPECT_TRUE(scene.dams[0].axis.has_z);

  const std::string text = preview_text(c, scene);
  EXPECT_THAT(text, HasSubstr("EPSG:31287"));
  EXPECT_THAT(text, HasSubstr("left out: entrainment (ENT), resistance (RES)"));
  // Up to 2.57 m at a spacing of 2 m: its thickness counts across the ground, which is steep.
  EXPECT_THAT(text, HasSubstr("the release is only 1.3 particles deep"));
  EXPECT_THAT(text, HasSubstr("crest at 1079.00 to 1184.00 m"));

  const TemporaryFolder folder;
  RunOptions options;
  options.folder = folder / "run";
  const RunResult result = run_case(c, options);
  EXPECT_EQ(result.end, RunEnd::finished) << result.reason;
  EXPECT_THAT(result.summary, testing::Contains(HasSubstr("thinner than its particles resolve")));
}

TEST(Bhutan, ARasterWithAWrongTagIsRefusedByTheNameOfItsTag) {
  const fs::path data = data_folder() / "terrain" / "bhutan_2m";
  if (!fs::exists(data)) GTEST_SKIP() << "no data: set SABO_DATA";
  Case c;
  c.terrain.dem = data / "DEM.tif";
  c.release.thickness_raster = data / "erosion.tif";
  c.numerics.spacing = 1;
  Faults faults;
  make_scene(c, faults);
  ASSERT_EQ(faults.list().size(), 1u);
  EXPECT_THAT(faults.list()[0].place, HasSubstr("release.thickness_raster"));
  EXPECT_THAT(faults.list()[0].problem, HasSubstr("EPSG:27700"));
  EXPECT_THAT(faults.list()[0].problem, HasSubstr("EPSG:5266"));
}

}  // namespace
}  // namespace sabo
