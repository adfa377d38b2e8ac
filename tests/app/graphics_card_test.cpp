#include <filesystem>

#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"
#include "solver/make_backend.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

/// Where there is no graphics card to run on.
class WithoutCard : public testing::Test {
 protected:
  void SetUp() override {
    fault_ = missing_backend(BackendKind::cuda);
    if (fault_.empty()) GTEST_SKIP() << "there is a graphics card";
    ASSERT_EQ(in_folder("sabo new yohutagawa demo").code, 0);
  }
  Outcome in_folder(const std::string& command) const {
    return run_shell("cd '" + (folder_ / "").string() + "' && " + command);
  }
  TemporaryFolder folder_;
  std::string fault_;
};

TEST_F(WithoutCard, ARunEndsBeforeItLeavesAnything) {
  const Outcome run = in_folder("sabo run demo --spacing 4 --backend cuda");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.text, HasSubstr("numerics.backend: " + fault_ + "; use --backend cpu\n"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "demo-run"));
}

TEST_F(WithoutCard, CheckForecastsTheMemoryThatOneWouldNeed) {
  const Outcome check = in_folder("sabo check demo --spacing 4 --backend cuda");
  EXPECT_EQ(check.code, 0) << check.text;
  EXPECT_THAT(check.text, HasSubstr(" MB of the graphics card\n"));
  EXPECT_THAT(check.text, HasSubstr("not known, for the backend is missing on this machine"));
  EXPECT_THAT(check.text, HasSubstr("  - numerics.backend: " + fault_));
}

TEST_F(WithoutCard, BenchNamesTheWayOut) {
  const Outcome bench = run_shell("sabo bench --quick --backend cuda");
  EXPECT_EQ(bench.code, 2);
  EXPECT_THAT(bench.text, HasSubstr("--backend: " + fault_ + "; measure --backend cpu\n"));
  EXPECT_THAT(run_shell("sabo bench --backend gpu").text,
              HasSubstr("there is no backend \"gpu\" to measure; give cpu or cuda"));
}

}  // namespace
}  // namespace sabo
