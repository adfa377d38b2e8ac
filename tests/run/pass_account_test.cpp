#include "run/pass_account.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// 6 s in two passes.
PassTimes two_passes() {
  PassTimes times;
  times["stress"] = {"stress", 2, 10, 0};
  times["force sweep"] = {"force sweep", 4, 20, 1'000'000'000};
  return times;
}

TEST(PassShares, AreSortedAndSumUpToTheWallTime) {
  const auto shares = pass_shares(two_passes(), 8);
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_EQ(shares[0].name, "force sweep");
  EXPECT_EQ(shares[0].share, 0.5);
  EXPECT_EQ(shares[0].pair_rate, 2.5e8);
  EXPECT_EQ(shares[1].share, 0.25);
  EXPECT_EQ(shares[1].pair_rate, 0);
  EXPECT_EQ(shares[2].name, "everything else");
  EXPECT_EQ(shares[2].seconds, 2);
}

// Clocks of passes and of the run are not read at the same moment.
TEST(PassShares, LeaveNothingNegative) {
  EXPECT_EQ(pass_shares(two_passes(), 5.9).back().seconds, 0);
  EXPECT_EQ(pass_shares({}, 0).back().share, 0);
}

TEST(PassShares, AreATableAndPartOfTheManifest) {
  const auto shares = pass_shares(two_passes(), 8);
  EXPECT_THAT(pass_table(shares).rows[0],
              ElementsAre("force sweep", "4.00", "50.0", "20", "250.0"));
  EXPECT_THAT(pass_table(shares).rows[2], ElementsAre("everything else", "2.00", "25.0", "-", "-"));
  EXPECT_THAT(
      passes_toml(shares),
      HasSubstr("[[passes]]\nname = \"stress\"\nseconds = 2\nshare = 0.2500\ncalls = 10\n"));
}

TEST(SolverTotals, AreMeansOverTheSteps) {
  const SolverTotals totals{2000, 10, 4, 5000};
  EXPECT_EQ(solver_text(totals),
            "2000 steps of 5 ms in the mean, 500 steps/s, 2.5 iterations of the viscous solve a "
            "step");
  EXPECT_EQ(solver_toml(totals),
            "\n[solver]\nmean_dt = 0.005\nmean_iterations = 2.5\nsteps_per_second = 500\n");
  EXPECT_THAT(solver_text({2000, 10, 4, 0}), Not(HasSubstr("iterations")));
  EXPECT_THAT(solver_text({}), HasSubstr("0 steps of 0 ms"));
}

}  // namespace
}  // namespace sabo
