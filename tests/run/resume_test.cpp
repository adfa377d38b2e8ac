#include <algorithm>
#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "support/archives.hpp"
#include "support/temporary_folder.hpp"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/case_file/read_case.hpp"
#include "run/channel.hpp"
#include "run/checkpoints.hpp"
#include "run/finished_run.hpp"
#include "run/flow.hpp"
#include "run/scene_of.hpp"
#include "run/simulation.hpp"

// Mud of 0.4 m in a tank, which breaks, meets a wall and comes to rest.

namespace sabo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string tank_case(const std::string& numerics) {
  return "[terrain.plane]\nextent = [-0.5, -0.5, 2.5, 1.1]\n"
         "[release]\nbox = [0, 0, 0, 0.8, 0.6, 0.4]\njitter = 0.1\n"
         "[[body]]\nname = \"tank\"\nkind = \"tank\"\nmin = [0, 0, 0]\nmax = [2, 0.6, 1]\n"
         "[[structure]]\nname = \"wall\"\nline = [[1.4, 0], [1.4, 0.6]]\nheight = 0.2\n"
         "thickness = 0.4\n"
         "[[section]]\nline = [[1.1, 0.6], [1.1, 0]]\n"
         "[[gauge]]\nplace = [1.1, 0.3]\n"
         "[[zone]]\npolygon = [[1, 0], [1.3, 0], [1.3, 0.6], [1, 0.6]]\n"
         "[material]\ndensity = 1600\nrheology = \"bingham\"\nviscosity = 1\ncohesion = 500\n"
         "friction_angle = 0\n"
         "[numerics]\nspacing = 0.08\nthreads = 1\n" +
         numerics;
}

const std::string fast =
    "method = \"fast\"\nsleep_speed = 0.5\nsleep_time = 0.02\nparticle_shifting = "
    "0.1\n[run]\nduration = 0.6\noutput_interval = 0.1\nseries_interval = 0.02\n";
const std::string paper =
    "method = \"paper\"\nreference_speed = 4\n[run]\nduration = 0.2\noutput_interval = "
    "0.05\nseries_interval = 0.01\n";

Case read(const std::string& text) {
  Faults faults;
  Case c = read_case_text(text, "/", faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
  return c;
}

using test::archived;
using test::restore;

void steps(Flow& flow, int count) {
  for (int k = 0; k < count; ++k) flow.stepper().step();
}

/// Without what it took in time.
std::string state_of(Flow& flow) {
  flow.backend().pass_times().clear();
  return archived(flow);
}

void expect_same_bits_after_restoring(const std::string& numerics) {
  const Case c = read(tank_case(numerics));
  const Scene scene = scene_of(c);
  Flow whole(c, scene);
  std::vector<std::string> states;
  for (int k = 0; k < 12; ++k) {
    steps(whole, 17);  // neither with the renewal of neighbours nor with falling asleep
    states.push_back(archived(whole));
  }
  const std::string last = state_of(whole);
  for (const std::size_t k : {0U, 3U, 10U}) {
    Case other = c;
    other.numerics.threads = k == 10 ? 2 : 1;
    Flow resumed(other, scene);
    restore(resumed, states[k]);
    steps(resumed, 17 * static_cast<int>(states.size() - 1 - k));
    EXPECT_TRUE(state_of(resumed) == last) << "from state " << k;
  }
}

TEST(Resume, AFlowGoesOnWithTheSameBits) {
  expect_same_bits_after_restoring(fast);
  expect_same_bits_after_restoring(paper);
}

TEST(Resume, TheTestHasSleepingParticles) {
  const Case c = read(tank_case(fast));
  const Scene scene = scene_of(c);
  Flow flow(c, scene);
  std::size_t most = 0;
  for (int k = 0; k < 12; ++k) {
    steps(flow, 17);
    most = std::max(most, flow.backend().asleep_count());
  }
  EXPECT_GT(most, 0U);
}

TEST(Resume, AStateOfAnotherFlowIsRefused) {
  const Case c = read(tank_case(fast));
  const Scene scene = scene_of(c);
  Flow flow(c, scene);
  const std::string bytes = archived(flow);
  EXPECT_THROW(restore(flow, bytes.substr(0, bytes.size() / 2)), RunError);
  EXPECT_THROW(restore(flow, bytes + "x"), RunError);
  flow.backend().fluid().position[7].x = 1e300;
  EXPECT_THROW(restore(flow, archived(flow)), RunError);
}

/// Every file of a run folder but those that tell of the computing or name the folder.
std::map<std::string, std::string> results_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    const bool is_of_computing = name.starts_with("checkpoint") || name == ".lock" ||
                                 name == "manifest.toml" || name == "index.html" ||
                                 name == "case.toml" || name == "frames/paraview.pvsm";
    if (!entry.is_regular_file() || is_of_computing) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    files[name] = text.str();
  }
  return files;
}

/// The manifest up to the times of computing.
std::string facts_in(const fs::path& folder) {
  std::istringstream manifest(FinishedRun{{}, folder}.text_of("manifest.toml"));
  std::string kept;
  for (std::string line; std::getline(manifest, line) && line != "[solver]";)
    if (!line.starts_with("started") && !line.starts_with("wall_s") && !line.starts_with("resumed"))
      kept += line + "\n";
  return kept;
}

void expect_same_results(const fs::path& a, const fs::path& b) {
  const auto expected = results_in(a), given = results_in(b);
  EXPECT_GT(expected.size(), 30U);
  for (const auto& [name, text] : expected) {
    ASSERT_TRUE(given.contains(name)) << name;
    EXPECT_TRUE(given.at(name) == text) << name;
  }
  for (const auto& [name, text] : given) EXPECT_TRUE(expected.contains(name)) << name;
  EXPECT_EQ(facts_in(a), facts_in(b));
}

struct Stopped {
  RunResult result;
  int stops = 0;
  std::string notes;
};

/// Stops a run after some steps, three times, and lets it go on each time.
Stopped run_with_stops(Case c, const fs::path& folder) {
  Stopped run;
  RunOptions options;
  options.folder = folder;
  options.on_note = [&](const std::string& line) { run.notes += line + "\n"; };
  while (true) {
    std::atomic<bool> stop = false;
    options.stop = &stop;
    options.progress_interval = 0;  // at each step
    int steps_left = 10 + 7 * run.stops;
    options.on_progress = [&](const RunProgress&) { stop = run.stops < 3 && --steps_left <= 0; };
    run.result = run_case(c, options);
    if (run.result.end != RunEnd::interrupted) return run;
    ++run.stops;
    options.former = FormerRun::resumed;
    c.numerics.threads = 1 + run.stops % 2;
    c.run.checkpoint_interval = run.stops % 2 == 0 ? 0.05 : 600;
  }
}

void expect_same_results_after_stops(const std::string& text) {
  const TemporaryFolder folder;
  const Case c = read(text);
  RunOptions options;
  options.folder = folder / "whole/run";
  EXPECT_EQ(run_case(c, options).end, RunEnd::finished);
  const Stopped run = run_with_stops(c, folder / "stopped/run");
  EXPECT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  EXPECT_EQ(run.stops, 3);
  EXPECT_THAT(run.notes, HasSubstr("Goes on from "));
  expect_same_results(folder / "whole/run", folder / "stopped/run");
}

TEST(Resume, AStoppedRunGivesTheSameFilesFast) { expect_same_results_after_stops(tank_case(fast)); }
TEST(Resume, AStoppedRunGivesTheSameFilesPaper) {
  expect_same_results_after_stops(tank_case(paper));
}

/// With water that stands beyond the inflow.
std::string channel_case(const std::string& inflows, double duration) {
  return channel + "[release]\nbox = [7, 2, 0, 8, 3, 0.8]\n" + inflows +
         "[numerics]\nspacing = 0.25\nthreads = 1\n" +
         fmt::format("[run]\nduration = {}\noutput_interval = 0.5\nseries_interval = 0.1\n",
                     duration);
}

TEST(Resume, AStoppedInflowGivesTheSameFiles) {
  expect_same_results_after_stops(channel_case(inflow + steady, 1.5));
}

// An inflow changes the particles at one step in a dozen; these end at ten in a row.
TEST(Resume, ARunWithAnInflowHasACheckpointWhereverItEnds) {
  for (int k = 0; k < 10; ++k) {
    const TemporaryFolder folder;
    const double duration = 0.2 + 0.004 * k;
    const Case c = read(channel_case(inflow + steady, duration));
    RunOptions options;
    options.folder = folder / "run";
    ASSERT_EQ(run_case(c, options).end, RunEnd::finished);
    const auto found = find_checkpoints(folder / "run/checkpoint", [](const std::string&) {});
    ASSERT_FALSE(found.empty()) << duration;
    EXPECT_GT(found.front().head.time, duration - 0.02);
  }
}

TEST(Resume, ARunWithAnInflowIsNotBranchedToACaseWithoutOne) {
  const TemporaryFolder folder;
  RunOptions options;
  options.folder = folder / "run";
  run_case(read(channel_case(inflow + steady, 0.3)), options);
  options.folder = folder / "branch";
  options.branch = {folder / "run", 0.3};
  try {
    run_case(read(channel_case("", 0.6)), options);
    FAIL() << "branched";
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a run with inflows cannot be branched"));
  }
}

TEST(Resume, ACaseThatHasMovedGoesOn) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "old");
  folder.write("old/release.txt", "0.2 0.2 0.05\n0.3 0.3 0.05\n");
  const auto moved_to = [&](const std::string& place) {
    Faults faults;
    Case c = read_case_text(
        "[terrain.plane]\nextent = [0, 0, 2, 1]\n[release]\npoints = \"release.txt\"\npoint_volume "
        "= 0.001\n"
        "[material]\nrheology = \"newtonian\"\n"
        "[numerics]\nspacing = 0.1\nthreads = 1\n[run]\nduration = 0.02\n",
        folder / place, faults);
    for (const Fault& fault : faults.list()) ADD_FAILURE() << to_string(fault);
    return c;
  };
  RunOptions options;
  options.folder = folder / "run";
  run_case(moved_to("old"), options);
  fs::rename(folder / "old", folder / "new");
  Case c = moved_to("new");
  c.run.duration = 0.04;
  options.former = FormerRun::resumed;
  EXPECT_EQ(run_case(c, options).end, RunEnd::finished);
}

}  // namespace
}  // namespace sabo
