#include <filesystem>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The example at a spacing at which a step takes milliseconds.
class RunCommand : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(in_folder("sabo new yohutagawa demo").code, 0); }

  Outcome in_folder(const std::string& command) const {
    return run_shell("cd '" + (folder_ / "").string() + "' && " + command);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  TemporaryFolder folder_;
};

TEST_F(RunCommand, WritesARunFolderThatInfoReads) {
  const Outcome run = in_folder("sabo run demo --spacing 4 --duration 0.1");
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_THAT(run.text, HasSubstr("Results go to demo-run\n"));
  EXPECT_THAT(run.text, HasSubstr("\nOpen demo-run/index.html\n"));
  EXPECT_THAT(run.text, Not(HasSubstr("\r")));
  EXPECT_TRUE(exists("demo-run/index.html"));

  const Outcome info = in_folder("sabo info demo-run");
  EXPECT_EQ(info.code, 0) << info.text;
  EXPECT_THAT(info.text, HasSubstr("  end                  finished\n"));
  EXPECT_THAT(info.text, HasSubstr("  simulated            0.1 s\n"));
  EXPECT_THAT(info.text, HasSubstr("  released             8863 m3\n"));
}

TEST_F(RunCommand, CheckDrawsAPictureAndPlotAPage) {
  const Outcome check = in_folder("sabo check demo --no-forecast --spacing 4");
  EXPECT_EQ(check.code, 0) << check.text;
  EXPECT_THAT(check.text, HasSubstr("\nPicture: demo-check.svg\n"));
  EXPECT_THAT(folder_.read("demo-check.svg"), HasSubstr(">upper fan</text>"));
  EXPECT_EQ(in_folder("sabo check demo --no-forecast -o there.svg").code, 0);
  EXPECT_TRUE(exists("there.svg"));

  ASSERT_EQ(in_folder("sabo run demo --spacing 4 --duration 0.1").code, 0);
  const Outcome plot = in_folder("sabo plot demo-run --times 0,0.1");
  EXPECT_EQ(plot.code, 0) << plot.text;
  EXPECT_EQ(plot.text, "Open demo-run/states.html\n");
  EXPECT_TRUE(exists("demo-run/pictures/state_speed_flow_00001_3d.svg"));
  const Outcome beyond = in_folder("sabo plot demo-run --times 5");
  EXPECT_EQ(beyond.code, 2);
  EXPECT_THAT(beyond.text, HasSubstr("5 s is not within the run; give times from 0 to 0.1 s"));
}

TEST_F(RunCommand, ReplacesARunOnlyWhenTold) {
  const std::string command = "sabo run demo -o out --spacing 4 --duration 0.01";
  ASSERT_EQ(in_folder(command).code, 0);
  const Outcome again = in_folder(command);
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.text, HasSubstr("--overwrite"));
  EXPECT_EQ(in_folder(command + " --overwrite").code, 0);
}

TEST_F(RunCommand, WritesItsResultsWhenInterrupted) {
  // Without --foreground the program would get the signal twice, as if one pressed Ctrl-C again.
  for (const std::string signal : {"INT", "TERM"}) {
    const Outcome run = in_folder("timeout --foreground --preserve-status -s " + signal +
                                  " 3 \"" SABO_PROGRAM "\" run demo -o " + signal +
                                  " --spacing 4 --duration 1e5 --threads 1");
    EXPECT_EQ(run.code, 130) << run.text;
    EXPECT_THAT(run.text, HasSubstr("Open " + signal + "/index.html\n"));
    EXPECT_TRUE(exists(signal + "/index.html"));
  }
}

TEST_F(RunCommand, WritesItsResultsWhenTheRunFails) {
  // At a sound speed of 0.3 m/s the release is squeezed by its own weight to twice its density.
  std::string text = folder_.read("demo/case.toml");
  const std::string key = "reference_speed = 20";
  text.replace(text.find(key), key.size(),
               "reference_speed = 0.1\nh_max = 0.01\nsound_speed_factor = 1");
  folder_.write("demo/case.toml", text);
  const Outcome run = in_folder("sabo run demo --spacing 4");
  EXPECT_EQ(run.code, 3) << run.text;
  EXPECT_THAT(run.text, HasSubstr("error: the density left its range"));
  EXPECT_TRUE(exists("demo-run/index.html"));
}

TEST_F(RunCommand, StudyRunsEachSpacingOnce) {
  const std::string command = "sabo study demo --spacings 4,5 --duration 0.05 --threads 1";
  const Outcome study = in_folder(command);
  EXPECT_EQ(study.code, 0) << study.text;
  EXPECT_THAT(study.text, HasSubstr("Run 1 of 2: spacing-5\n"));
  EXPECT_THAT(study.text, HasSubstr("two spacings: first order is assumed"));
  EXPECT_THAT(study.text, HasSubstr("\nOpen demo-study/index.html\n"));
  for (const char* file : {"index.html", "table.csv", "runs.csv", "study.toml",
                           "spacing-4/index.html", "pictures/quantity_01.svg"})
    EXPECT_TRUE(exists("demo-study/" + std::string(file))) << file;
  EXPECT_THAT(folder_.read("demo-study/table.csv"), Not(HasSubstr("nan")));
  EXPECT_THAT(folder_.read("demo-study/table.csv"), HasSubstr("\nfront run-out [m],"));

  const Outcome again = in_folder(command);
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.text, HasSubstr("Run 2 of 2: spacing-4 is there already\n"));
  const Outcome elsewhere = in_folder(command + " -o demo");
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_THAT(elsewhere.text, HasSubstr("demo: holds files that are not those of a study"));
}

TEST_F(RunCommand, CheckDescribesTheCase) {
  const Outcome outcome = in_folder("sabo check demo --no-forecast --spacing 2");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.text, HasSubstr("EPSG:32652"));
  EXPECT_THAT(outcome.text, HasSubstr("particles at 2 m"));
}

}  // namespace
}  // namespace sabo
