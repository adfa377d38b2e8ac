#include "run/view.hpp"

#include <algorithm>
#include <filesystem>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/finished_run.hpp"
#include "run/new_case.hpp"
#include "run/view_solids.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A dam of 2 m by 10 m by 4 m with a slit of 1 m down to the ground, and a house, which stands in
// no
// [[body]] of the case.
TEST(ViewSolids, AreStructuresWithTheirOpeningsAndBuildings) {
  const TemporaryFolder folder;
  Faults faults;
  const Case c = read_case_text(R"(
[terrain.plane]
extent = [0, 0, 40, 20]
[[structure]]
name = "dam"
line = [[20, 5], [20, 15]]
height = 4
thickness = 2
[[structure.slit]]
centre = 5
width = 1
[[structure]]
name = "house"
kind = "building"
polygon = [[30, 8], [34, 8], [34, 12], [30, 12]]
height = 3
[release]
box = [2, 8, 0, 6, 12, 1]
[numerics]
spacing = 0.25
[run]
duration = 1
)",
                                folder / "", faults);
  const Scene scene = make_scene(c, faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  const std::vector<ViewSolid> solids = view_solids(c, scene);
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[0].name, "dam");
  EXPECT_EQ(solids[1].name, "house");
  EXPECT_NEAR(volume(solids[1].mesh), 4 * 4 * 3, 1e-6);
  // Nothing of the dam lies within the slit above the ground.
  for (const Vec3d& v : solids[0].mesh.vertices)
    EXPECT_FALSE(std::abs(v.y + scene.frame.origin_y - 10) < 0.45 && v.z > 0.01)
        << v.y << " " << v.z;
}

/// A moment of the example.
class View : public testing::Test {
 protected:
  View() {
    new_case("yohutagawa", folder_ / "case");
    run_ = run_to_end(
        folder_ / "case", folder_ / "run",
        {{"numerics", "spacing", 4.0}, {"run", "duration", 0.2}, {"run", "output_interval", 0.1}});
  }
  std::string text_of(const std::string& file) const { return run_.text_of(file); }

  TemporaryFolder folder_;
  FinishedRun run_;
};

TEST_F(View, ARunWritesPageSceneFramesAndSurfaces) {
  EXPECT_EQ(run_.result.end, RunEnd::finished) << run_.result.reason;
  EXPECT_THAT(text_of("view/index.html"), HasSubstr("<!doctype html>"));
  EXPECT_THAT(text_of("view/scene.js"), HasSubstr("\"frames\":[[0,0,"));
  EXPECT_THAT(text_of("view/scene.js"), HasSubstr("{\"name\":\"dam\",\"triangles\":"));
  EXPECT_THAT(text_of("view/frame_00002.js"), HasSubstr("sabo_frame({\"number\":2,"));
  EXPECT_THAT(text_of("frames/surface.pvd"), HasSubstr("file=\"surface_00002.vtp\""));
  EXPECT_THAT(text_of("frames/surface_00002.vtp"), HasSubstr("Name=\"depth [m]\""));
  EXPECT_THAT(text_of("index.html"), HasSubstr("view/index.html"));
}

TEST_F(View, IsMadeAgainWhereItIsMissingOrOfAnotherVersionAndElseLeftAlone) {
  const std::string scene = text_of("view/scene.js"), frame = text_of("view/frame_00001.js");
  fs::remove_all(run_.folder / "view");
  EXPECT_EQ(view_of_run(run_.folder), run_.folder / "view");
  EXPECT_EQ(text_of("view/scene.js"), scene);
  EXPECT_EQ(text_of("view/frame_00001.js"), frame);
  folder_.write("run/view/scene.js", "sabo_scene({\"format\":0,");
  folder_.write("run/view/frame_00077.js", "old");
  view_of_run(run_.folder);
  EXPECT_EQ(text_of("view/scene.js"), scene);
  EXPECT_FALSE(fs::exists(run_.folder / "view/frame_00077.js"));
  folder_.write("run/view/scene.js", scene + "// mine");
  view_of_run(run_.folder);
  EXPECT_EQ(text_of("view/scene.js"), scene + "// mine");
}

TEST(ViewOfRun, AFolderThatIsNoRunIsRefused) {
  const TemporaryFolder folder;
  const Fault fault = fault_of([&] { view_of_run(folder / ""); });
  EXPECT_THAT(fault.problem, HasSubstr("is not the folder of a run"));
}

}  // namespace
}  // namespace sabo
