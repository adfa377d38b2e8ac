#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/folders.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/case_file/read_case.hpp"
#include "run/channel.hpp"
#include "run/new_case.hpp"
#include "run/simulation.hpp"

namespace sabo {
namespace {

Case short_valley_run(const TemporaryFolder& folder) {
  new_case("yohutagawa", folder / "case");
  Faults faults;
  Case c = read_case(folder / "case", faults);
  faults.throw_if_any();
  c.numerics.spacing = 3;
  c.numerics.threads = 1;
  c.run.duration = 0.2;
  return c;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

RunOptions into(const std::filesystem::path& folder) {
  RunOptions options;
  options.folder = folder;
  return options;
}

TEST(Failure, AFullDiskIsToldAndTheManifestSaysSo) {
  const TemporaryFolder folder;
  const Case c = short_valley_run(folder);
  std::string reason;
  {
    // Room for the manifest and series, not for the ground.
    const FullDisk disk(100'000);
    try {
      const RunResult result = run_case(c, into(folder / "run"));
      EXPECT_EQ(result.end, RunEnd::failed);
      reason = result.reason;
    } catch (const RunError& error) {
      reason = error.what();
    }
  }
  EXPECT_NE(reason, "");
  const std::string manifest = text_of(folder / "run" / "manifest.toml");
  EXPECT_NE(manifest.find("end = \"failed\""), std::string::npos) << manifest;
}

TEST(Failure, OutputsUpToADensityFailureAreWritten) {
  const TemporaryFolder folder;
  Case c = short_valley_run(folder);
  c.run.duration = 10;
  c.numerics.reference_speed = 0;
  c.numerics.h_max = 0.05;  // a sound speed of 7 m/s cannot carry the weight
  const RunResult result = run_case(c, into(folder / "run"));
  EXPECT_EQ(result.end, RunEnd::failed);
  EXPECT_NE(result.reason.find("reference_speed"), std::string::npos) << result.reason;
  EXPECT_TRUE(std::filesystem::exists(result.index));
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "maps" / "dep.tif"));
  EXPECT_NE(text_of(folder / "run" / "manifest.toml").find("end = \"failed\""), std::string::npos);
}

/// A body inside of the wall of the channel is found out when particles are laid out, after the
/// folder is made: the run does not stay "running".
TEST(Failure, WhatTheLayoutFindsIsInTheManifest) {
  const TemporaryFolder folder;
  Faults faults;
  const Case c = read_case_text(
      channel +
          "[[body]]\nname = \"lost\"\nkind = \"box\"\nmin = [2, 0.3, 0]\nmax = [4, 1.2, 2]\n" +
          inflow + steady + "[run]\nduration = 0.1\n[numerics]\nspacing = 0.25\nthreads = 1\n",
      repository() / "examples/inflow", faults);
  faults.throw_if_any();
  EXPECT_THROW(run_case(c, into(folder / "run")), CaseError);
  const std::string manifest = text_of(folder / "run" / "manifest.toml");
  EXPECT_NE(manifest.find("end = \"failed\""), std::string::npos) << manifest;
  EXPECT_NE(manifest.find("lost"), std::string::npos) << manifest;
}

TEST(Failure, AFolderWithOtherFilesIsRefused) {
  const TemporaryFolder folder;
  const Case c = short_valley_run(folder);
  EXPECT_THROW(run_case(c, into(folder / "case")), CaseError);
}

TEST(Failure, AStopLeavesTheResultsSoFar) {
  const TemporaryFolder folder;
  Case c = short_valley_run(folder);
  c.run.duration = 1000;
  std::atomic<bool> stop = false;
  RunOptions options = into(folder / "run");
  options.stop = &stop;
  options.on_progress = [&](const RunProgress&) { stop = true; };
  const RunResult result = run_case(c, options);
  EXPECT_EQ(result.end, RunEnd::interrupted);
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "maps" / "pfd.tif"));
}

}  // namespace
}  // namespace sabo
