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

Surface level_ground() {
  Raster ground(Grid{.columns = 60, .rows = 60, .west = -30, .north = 30, .dx = 1, .dy = 1});
  return Surface(ground);
}

// 20 m along y, 2.5 m thick, 6 m high, with a notch 2 m deep and 4 m wide, whose sides rise 2 m
// over 1 m. It goes two cells into the ground: (8 x 20 - 4 x 2 - 2 x 1) x 2.5 = 375 m3.
TEST(DamMesh, EnclosesTheWallAndItsNotch) {
  CheckDam dam;
  dam.axis = {{{0, -10, 0}, {0, 10, 0}}, false};
  dam.crest = 6;
  dam.thickness = 2.5;
  dam.notch = Notch{9, 4, 2, 0.5};
  TriangleMesh mesh = dam_mesh(dam, level_ground());
  double lowest = 0;
  for (const Vec3d& vertex : mesh.vertices) lowest = std::min(lowest, vertex.z);
  EXPECT_DOUBLE_EQ(lowest, -2);
  append(mesh, {{{-1.25, -10, -2}, {1.25, -10, -2}, {1.25, 10, -2}, {-1.25, 10, -2}},
                {{0, 2, 1}, {0, 3, 2}}});  // the missing bottom
  EXPECT_NEAR(volume(mesh), 375, 0.02);    // sides of the notch are 1 mm off
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
