#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string inflow_line = "[[inflow]]\nline = [[0, 0], [0, 5]]\n";
const std::string surge = "[[inflow.surge]]\npeak_time = 2\nend = 5\npeak_discharge = 3\n";

/// Faults of the smallest case with an inflow, whose keys start at line 13.
std::vector<std::string> inflow(const std::string& keys) {
  return messages(smallest_case + inflow_line + keys);
}

TEST(InflowRules, AnInflowStandsInForARelease) {
  EXPECT_THAT(inflow(surge), IsEmpty());
  const std::string alone =
      with(smallest_case, "[release]\npolygon = \"release.gpkg\"\nvolume = 100\n", "");
  EXPECT_THAT(messages(alone + inflow_line + surge), IsEmpty());
}

TEST(InflowRules, OneWayOfDischarge) {
  EXPECT_THAT(inflow(""), ElementsAre("case.toml:11 inflow[1]: has no discharge; give one of "
                                      "hydrograph, a CSV file, and [[inflow.surge]]"));
  EXPECT_THAT(inflow("hydrograph = \"points.txt\"\n" + surge),
              ElementsAre("case.toml:11 inflow[1]: has a hydrograph and surges; give one of "
                          "hydrograph, a CSV file, and [[inflow.surge]]"));
  EXPECT_THAT(inflow("speed = 2\nfroude = 2\n" + surge),
              ElementsAre("case.toml:14 inflow[1].froude: the speed is given too; give one of "
                          "speed and froude"));
}

TEST(InflowRules, ASurgeRisesBeforeItFalls) {
  EXPECT_THAT(inflow("[[inflow.surge]]\nstart = 5\npeak_time = 5\nend = 5\npeak_discharge = 3\n"),
              ElementsAre("case.toml:16 inflow[1].surge[1].end: is not after its start at 5 s; "
                          "give a later time"));
  EXPECT_THAT(inflow("[[inflow.surge]]\nstart = 2\npeak_time = 1\nend = 5\npeak_discharge = 3\n"),
              ElementsAre("case.toml:15 inflow[1].surge[1].peak_time: is not between 2 and 5 s, "
                          "when the surge passes; give a time between its start and its end"));
  EXPECT_THAT(inflow("[[inflow.surge]]\npeak_time = 1\nend = 5\npeak_discharge = 0\n"),
              ElementsAre(testing::HasSubstr("inflow[1].surge[1].peak_discharge: ")));
}

}  // namespace
}  // namespace sabo
