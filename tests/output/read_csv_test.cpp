#include "io/output/read_csv.hpp"

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "io/output/csv.hpp"

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(NumberTable, ReadsWhatTheWriterWrites) {
  const TemporaryFolder folder;
  const auto file = folder / "series.csv";
  {
    CsvWriter writer(file, {"time [s]", "a \"dam\", old net discharge [m3/s]"});
    writer.append({0, -1.5});
    writer.append({0.25, 1e-9});
  }
  const auto table = read_number_table(file);
  ASSERT_TRUE(table);
  ASSERT_TRUE(table->find("a \"dam\", old net discharge [m3/s]"));
  EXPECT_THAT(*table->find("a \"dam\", old net discharge [m3/s]"), ElementsAre(-1.5, 1e-9));
  EXPECT_THAT(*table->find("time [s]"), ElementsAre(0, 0.25));
  EXPECT_FALSE(table->find("time"));
  EXPECT_FALSE(read_number_table(folder / "none.csv"));
}

TEST(NumberTable, RefusesWhatIsNone) {
  for (const char* text :
       {"", "\n1\n", "a,b\n1\n", "a\nx\n", "a\n1 \n", "a\nnan\n", "a\n1e999\n", "\"a\n1\n"})
    EXPECT_FALSE(parse_number_table(text)) << text;
  const TemporaryFolder folder;
  const auto file = folder.write("bad.csv", "a\nx\n");
  EXPECT_THAT(fault_of([&] { read_number_table(file); }).problem, HasSubstr("not a table"));
}

TEST(NumberTable, LeavesOutALineThatWasCutOff) {
  for (const char* end : {"", "3", "3,", "3,4.5"}) {
    const auto table = parse_number_table(std::string("a,b\n1,2\n") + end);
    ASSERT_TRUE(table) << end;
    EXPECT_THAT(table->columns[1], ElementsAre(2)) << end;
  }
  EXPECT_FALSE(parse_number_table("a,b"));
}

TEST(NumberTable, TakesAnyText) {
  EXPECT_TRUE(rc::check("columns are of one length", [] {
    const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("a1,\"\n.")));
    const auto table = parse_number_table(text);
    if (!table) return;
    for (const auto& column : table->columns)
      RC_ASSERT(column.size() == table->columns.front().size());
  }));
}

}  // namespace
}  // namespace sabo
