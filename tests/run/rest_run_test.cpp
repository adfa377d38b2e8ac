#include <cstdlib>
#include <string>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/finished_run.hpp"
#include "run/new_case.hpp"

// The limits are set so wide that a flow counts as at rest once it has moved by a spacing: what is
// tested is what a run does then. What rest is, tests/analysis says.

namespace sabo {
namespace {

using testing::HasSubstr;

FinishedRun run_with(const TemporaryFolder& folder, const std::string& stop, double duration) {
  const auto case_folder = folder / stop;
  new_case("yohutagawa", case_folder);
  std::ofstream(case_folder / "case.toml", std::ios::app)
      << "\nstop_at_rest = " << stop
      << "\nrest_time = 0.5\nrest_speed = 100\nrest_volume = 0.9\nrest_energy = 1\n"
         "rest_creep = 1e6\nseries_interval = 0.4\n";
  return run_to_end(case_folder, folder / (stop + "-run"),
                    {{"numerics", "spacing", 4.0},
                     {"numerics", "threads", std::int64_t{1}},
                     {"run", "duration", duration}});
}

double last_frame_time(const FinishedRun& run) {
  const std::string list = run.text_of("frames/flow.pvd");
  const std::string mark = "timestep=\"";
  return std::strtod(list.c_str() + list.rfind(mark) + mark.size(), nullptr);
}

TEST(RestRun, EndsAtRestAndSaysWhy) {
  const TemporaryFolder folder;
  const FinishedRun run = run_with(folder, "true", 20);
  ASSERT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  EXPECT_THAT(run.result.reason, HasSubstr("the flow came to rest: over 0.5 s 0 % of the volume "
                                           "faster than 100 m/s, kinetic energy "));
  EXPECT_THAT(run.result.reason, HasSubstr("(limits 90 %, 1, 1e+06)"));
  const double end = run.last_row("series/rest.csv").at("time [s]");
  // Free fall down the steepest 33 degrees takes sqrt(2 x 4 / (9.81 sin 33 deg)) = 1.2 s for 4 m.
  EXPECT_GT(end, 1.2);
  EXPECT_LT(end, 15);
  for (const char* series : {"front", "discharge", "volumes", "energy", "solver"})
    EXPECT_EQ(run.last_row(std::string("series/") + series + ".csv").at("time [s]"), end) << series;
  EXPECT_NEAR(last_frame_time(run), end, 1e-3);
  EXPECT_THAT(run.text_of("manifest.toml"),
              HasSubstr("\nend = \"finished\"\nreason = \"the flow "));
  EXPECT_THAT(run.text_of("manifest.toml"), HasSubstr("\nat_rest = true\n"));
  EXPECT_THAT(run.text_of("index.html"), HasSubstr("<dt>Stopped</dt><dd>the flow came to rest"));
}

TEST(RestRun, GoesOnWhenToldTo) {
  const TemporaryFolder folder;
  const FinishedRun run = run_with(folder, "false", 6);
  ASSERT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  EXPECT_EQ(run.result.reason, "");
  EXPECT_EQ(run.last_row("series/rest.csv").at("time [s]"), 6);
}

}  // namespace
}  // namespace sabo
