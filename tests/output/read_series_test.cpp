#include "io/output/read_series.hpp"

#include <cmath>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/csv.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;

TEST(ReadSeries, ReadsWhatTheWriterWrites) {
  const TemporaryFolder folder;
  {
    CsvWriter writer(folder / "a.csv", {"time [s]", "dam \"A\", new trapped [m3]"});
    writer.append({0.5, -2});
    writer.append({1, 1.23456789e-7});
  }
  const SeriesTable table = read_series(folder / "a.csv");
  EXPECT_THAT(table.names, ElementsAre("time [s]", "dam \"A\", new trapped [m3]"));
  ASSERT_TRUE(table.find("time [s]"));
  EXPECT_THAT(*table.find("time [s]"), ElementsAre(0.5, 1));
  EXPECT_THAT(table.columns[1], ElementsAre(-2, 1.23456789e-7));
  EXPECT_EQ(table.find("time"), nullptr);
  EXPECT_EQ(table.rows(), 2u);
}

TEST(ReadSeries, LeavesOutALineThatWasCutOff) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_series(folder.write("a.csv", "a,b\n1,2\n3,4.5")).rows(), 1u);
  EXPECT_EQ(read_series(folder.write("a.csv", "a,b\n1,2\n3\n5,6,7\n8,9\n")).rows(), 2u);
}

TEST(ReadSeries, TakesWhatIsNoNumberAsMissing) {
  const TemporaryFolder folder;
  const SeriesTable table = read_series(folder.write("a.csv", "a,b,c\r\n1,,x1\r\n"));
  EXPECT_DOUBLE_EQ(table.columns[0][0], 1);
  EXPECT_TRUE(std::isnan(table.columns[1][0]));
  EXPECT_TRUE(std::isnan(table.columns[2][0]));
}

TEST(ReadSeries, RefusesWhatIsNoTable) {
  const TemporaryFolder folder;
  EXPECT_NE(fault_of([&] { read_series(folder / "none.csv"); }).problem, "");
  EXPECT_NE(fault_of([&] { read_series(folder.write("a.csv", "a,b")); }).problem, "");
}

}  // namespace
}  // namespace sabo
