#include <gmock/gmock.h>
#include <gtest/gtest.h>
// rapidcheck needs gtest before it
#include <cmath>
#include <cstdio>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "io/gis/read_points.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ReadPoints : public testing::Test {
 protected:
  std::vector<Vec3d> read(const std::string& text, const Vec3d& offset = {}) {
    return read_points(folder_.write("points.txt", text), offset);
  }
  std::string problem(const std::string& text) {
    const Fault fault = fault_of([&] { read(text); });
    EXPECT_EQ(fault.place, "release.points");
    return fault.problem;
  }
  TemporaryFolder folder_;
};

TEST_F(ReadPoints, TakesBlanksTabsAndCommas) {
  EXPECT_THAT(
      read("  26.5   101.5\t1707.74 \r\n1,2,3\n+1 , -2,\t3e1\n7 8 9"),
      ElementsAre(Vec3d{26.5, 101.5, 1707.74}, Vec3d{1, 2, 3}, Vec3d{1, -2, 30}, Vec3d{7, 8, 9}));
}

TEST_F(ReadPoints, SkipsCommentsBlankLinesAndOneHeader) {
  EXPECT_THAT(read("\xEF\xBB\xBF# made by hand\n\nx y z\n1 2 3 # first\n"),
              ElementsAre(Vec3d{1, 2, 3}));
}

TEST_F(ReadPoints, AddsTheOffset) {
  EXPECT_THAT(read("26.5 101.5 1707.5", {618166.5, 3996330.5, 0}),
              ElementsAre(Vec3d{618193, 3996432, 1707.5}));
}

TEST_F(ReadPoints, NamesTheLineThatIsWrong) {
  EXPECT_THAT(problem("1 2 3\n4 5\n"), HasSubstr("line 2: \"4 5\" is not a point"));
  EXPECT_THAT(problem("1 2 3 4\n"), HasSubstr("line 1"));
  EXPECT_THAT(problem("1 2 3\n\n1,,3\n"), HasSubstr("line 3"));
  EXPECT_THAT(problem("1 2 nan\n"), HasSubstr("line 1"));
  EXPECT_THAT(problem("1 2 1e999\n"), HasSubstr("line 1"));
  EXPECT_THAT(problem("x y z\nx y z\n"), HasSubstr("line 2"));
  EXPECT_THAT(problem("1 2 3\n" + std::string(5000, ' ') + "\n"), HasSubstr("line 2: longer"));
  EXPECT_THAT(problem("x y z\n# nothing\n"), HasSubstr("no points"));
  EXPECT_THAT(fault_of([&] { read_points(folder_ / "none.txt", {}); }).problem,
              HasSubstr("cannot be opened"));
  EXPECT_THAT(fault_of([&] { read_points(folder_ / "", {}); }).problem,
              HasSubstr("cannot be opened"));
}

RC_GTEST_PROP(ReadPointsLaw, AnyBytesAreReadOrRefused, (const std::string& bytes)) {
  const TemporaryFolder folder;
  try {
    for (const Vec3d& p : read_points(folder.write("points.txt", bytes), {})) {
      RC_ASSERT(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
  } catch (const CaseError&) {
  }
}

RC_GTEST_PROP(ReadPointsLaw, SeventeenDigitsComeBackExactly, (double x, double y, double z)) {
  RC_PRE(std::isfinite(x) && std::isfinite(y) && std::isfinite(z));
  const TemporaryFolder folder;
  char line[100];
  std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", x, y, z);
  const auto points = read_points(folder.write("points.txt", line), {});
  RC_ASSERT(points.size() == 1u);
  RC_ASSERT(points[0] == (Vec3d{x, y, z}));
}

}  // namespace
}  // namespace sabo
