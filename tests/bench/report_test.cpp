#include "bench/report.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/cpu/pair_sweeps.hpp"
#include "bench/parts.hpp"
#include "bench/peak.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

TEST(Measurement, IsTheMedianWithItsSpread) {
  const Measurement odd("a/b", "m", Samples{{9, 1, 4}});
  EXPECT_EQ(odd.value, 4);
  EXPECT_EQ(odd.low, 1);
  EXPECT_EQ(odd.high, 9);
  EXPECT_EQ(odd.repeats, 3u);
  EXPECT_EQ(Measurement("a", "m", Samples{{9, 1, 4, 6}}).value, 5);
}

TEST(Report, AlignsItsColumns) {
  const BenchTable table{"Title", {"name", "m/s"}, {{"a", "1.25"}, {"longer", "100"}}, {"Note."}};
  EXPECT_EQ(text_of(table), "Title\n  name     m/s\n  a       1.25\n  longer   100\n  Note.\n");
}

TEST(Report, IsJsonWhateverTheNamesAndNumbers) {
  BenchMachine machine;
  machine.cpu = "a \"fast\" \\ one\n";
  const std::string json = json_of(machine, {Measurement("x", "m", Samples{{std::nan("")}})});
  EXPECT_THAT(json, HasSubstr(R"("cpu": "a \"fast\" \\ one ")"));
  EXPECT_THAT(json, HasSubstr(R"("name": "x", "value": null, "unit": "m")"));
}

TEST(Report, WarnsOfAMachineThatDoesSomethingElse) {
  BenchMachine machine;
  machine.cores = 4;
  machine.threads = 4;
  machine.load = 0.3;
  EXPECT_EQ(warning_of(machine), "");
  machine.load = 2;
  EXPECT_THAT(warning_of(machine), HasSubstr("Load 2.0 on 4 cores"));
  machine.threads = 2;  // there is room for both
  EXPECT_EQ(warning_of(machine), "");
}

TEST(DryTerrain, MayChangeAStepByThreePercent) {
  EXPECT_THAT(std::string(dry_terrain_verdict(1.029)), HasSubstr("costs nothing"));
  EXPECT_THAT(std::string(dry_terrain_verdict(0.971)), HasSubstr("costs nothing"));
  EXPECT_THAT(std::string(dry_terrain_verdict(1.031)), HasSubstr("more than the 3 %"));
  EXPECT_THAT(std::string(dry_terrain_verdict(0.6)), HasSubstr("too busy to tell"));
}

TEST(Peak, IsProbedWithEverySetOfTheSweeps) {
  const auto probes = all_fma_probes();
  ASSERT_EQ(probes.size(), all_pair_sweeps().size());
  for (std::size_t k = 0; k < probes.size(); ++k)
    EXPECT_STREQ(probes[k]->instruction_set, all_pair_sweeps()[k]->instruction_set);
}

// Each chain goes to the fixed point 1 of x -> a x + (1 - a): the sum over 12 chains and all lanes
// is their number, and 2 x 4 operations a round are done on each.
TEST(Peak, ProbesDoWhatTheyCount) {
  for (const FmaProbe* probe : all_fma_probes())
    EXPECT_NEAR(probe->run(100), static_cast<double>(probe->flops_per_round) / 8, 1e-2)
        << probe->instruction_set;
}

}  // namespace
}  // namespace sabo
