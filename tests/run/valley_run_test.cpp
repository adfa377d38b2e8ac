#include <string>

#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "run/finished_run.hpp"
#include "run/new_case.hpp"
#include "run/state_pictures.hpp"

// The example from its template to its run folder, coarse and short: the mass is two particles deep
// and on its way. What the numbers must be does not depend on that.

namespace sabo {
namespace {

FinishedRun run_example(const TemporaryFolder& folder, std::int64_t threads, double duration) {
  const auto name = "threads-" + std::to_string(threads);
  return run_to_end(folder / "case", folder / name,
                    {{"numerics", "spacing", 3.0},
                     {"numerics", "threads", threads},
                     {"run", "duration", duration}});
}

void expect_all_files(const FinishedRun& run) {
  for (const char* file : {"index.html",
                           "manifest.toml",
                           "case.toml",
                           "maps/dep.tif",
                           "maps/pfd.tif",
                           "maps/pfv.tif",
                           "maps/tarr.tif",
                           "maps/ppr.tif",
                           "maps/ground.tif",
                           "maps/res.tif",
                           "series/rest.csv",
                           "pictures/resolution.svg",
                           "series/zones.csv",
                           "series/front.csv",
                           "series/discharge.csv",
                           "series/volumes.csv",
                           "series/energy.csv",
                           "series/solver.csv",
                           "frames/flow.pvd",
                           "frames/ground.vtp",
                           "frames/flow_00000.vtp",
                           "frames/surface.pvd",
                           "frames/paraview.pvsm",
                           "frames/surface_00001.vtp",
                           "view/index.html",
                           "view/scene.js",
                           "view/frame_00001.js",
                           "pictures/deposit.svg",
                           "pictures/front_velocity.svg",
                           "pictures/discharge.svg",
                           "pictures/volumes.svg"})
    EXPECT_GT(run.text_of(file).size(), 0u) << file;
  Faults faults;
  EXPECT_EQ(read_case(run.folder, faults).numerics.spacing, 3);
  EXPECT_TRUE(faults.empty()) << "the case of a run folder cannot be read again";
}

/// A zone over the whole upper valley holds everything; those at the dam and below it nothing.
void expect_zones(const FinishedRun& run) {
  const auto zones = run.last_row("series/zones.csv");
  EXPECT_NEAR(zones.at("all volume [m3]"), 8863, 1e-3);
  EXPECT_GT(zones.at("all greatest depth [m]"), zones.at("all mean depth where wet [m]"));
  EXPECT_GT(zones.at("all mean depth where wet [m]"), zones.at("all mean depth [m]"));
  for (const char* zone : {"behind the dam", "below the dam", "upper fan", "lower fan"})
    EXPECT_EQ(zones.at(zone + std::string(" volume [m3]")), 0) << zone;
  EXPECT_NE(run.text_of("index.html").find("0.3 (published simulation)"), std::string::npos);
}

/// Pictures of the states; frames are 5 s apart, so of 6 s there are those at 0, 5 and 6 s.
void expect_states(const FinishedRun& run) {
  EXPECT_EQ(draw_states(run.folder, {}), run.folder / "states.html");
  const std::string page = run.text_of("states.html");
  for (const char* picture :
       {"state_depth_flow_00001_map.svg", "state_pressure_flow_00001_3d.svg"}) {
    EXPECT_NE(page.find(picture), std::string::npos) << picture;
    const std::string svg = run.text_of(std::string("pictures/") + picture);
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << picture;
    EXPECT_NE(svg.find(" at 5"), std::string::npos) << picture << " is not of its time";
    for (const char* odd : {"\"nan", " nan", ">nan"})
      EXPECT_EQ(svg.find(odd), std::string::npos) << picture;
  }
  EXPECT_THROW(draw_states(run.folder, {7}), CaseError) << "beyond the run";
  EXPECT_FALSE(run.text_of("pictures/state_depth_flow_00001_map.svg").empty()) << "is gone";
  EXPECT_THROW(draw_states(run.folder / "maps", {}), CaseError) << "no run";
}

void expect_sound_volumes(const FinishedRun& run) {
  constexpr double published = 8863;  // m3
  const auto volumes = run.last_row("series/volumes.csv");
  EXPECT_NEAR(volumes.at("released [m3]"), published, 1e-6 * published);
  EXPECT_NEAR(
      volumes.at("outflow [m3]") + volumes.at("dam trapped [m3]") + volumes.at("dam beyond [m3]"),
      volumes.at("released [m3]"), 1e-6 * published);
  // The dam is 500 m away: nothing has passed it or left.
  EXPECT_EQ(volumes.at("dam beyond [m3]"), 0);
  EXPECT_EQ(volumes.at("outflow [m3]"), 0);
  EXPECT_EQ(volumes.at("put back [count]"), 0) << "particles below the ground";
  EXPECT_NEAR(run.volume_of("maps/dep.tif"), published, 1e-3 * published);
  EXPECT_GE(run.volume_of("maps/pfd.tif"), run.volume_of("maps/dep.tif"));
}

TEST(ValleyRun, GoesFromTheTemplateToTheRunFolder) {
  const TemporaryFolder folder;
  new_case("yohutagawa", folder / "case");
  std::ofstream(folder / "case" / "case.toml", std::ios::app)
      << "[[zone]]\nname = \"all\"\n"
         "polygon = [[350000, 3129920], [350500, 3129920], [350500, 3130080], [350000, 3130080]]\n";
  const FinishedRun run = run_example(folder, 2, 6);
  ASSERT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  expect_all_files(run);
  expect_sound_volumes(run);
  expect_zones(run);
  expect_states(run);
  const auto front = run.last_row("series/front.csv");
  EXPECT_EQ(front.at("time [s]"), 6);
  // Slower than sliding without friction where it is steepest: 9.81 sin(33 deg) 6^2 / 2 = 96 m.
  EXPECT_GT(front.at("displacement [m]"), 1);
  EXPECT_LT(front.at("displacement [m]"), 96);
}

TEST(ValleyRun, NumberOfThreadsDoesNotChangeABit) {
  const TemporaryFolder folder;
  new_case("yohutagawa", folder / "case");
  const FinishedRun one = run_example(folder, 1, 2);
  const FinishedRun two = run_example(folder, 2, 2);
  ASSERT_EQ(one.result.end, RunEnd::finished) << one.result.reason;
  ASSERT_EQ(two.result.end, RunEnd::finished) << two.result.reason;
  for (const char* file :
       {"series/front.csv", "series/energy.csv", "series/solver.csv", "maps/dep.tif"})
    EXPECT_TRUE(one.text_of(file) == two.text_of(file)) << file;
}

}  // namespace
}  // namespace sabo
