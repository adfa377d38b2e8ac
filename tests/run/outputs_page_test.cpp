#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "io/output/read_csv.hpp"
#include "run/channel.hpp"
#include "run/finished_run.hpp"

// docs/outputs.md against what a run of three tenths of a second writes.

namespace sabo {
namespace {

using Names = std::set<std::string>;

/// One of everything that is measured, in the channel with a dam across it.
const std::string measured_channel = channel + inflow + steady + R"(
[[structure]]
name = "dam"
line = [[8, 1.5], [8, 3.5]]
height = 1
thickness = 0.5
[[section]]
name = "gate"
line = [[4, 1.5], [4, 3.5]]
[[gauge]]
name = "staff"
place = [5, 2.5]
[[zone]]
name = "pool"
polygon = [[6, 2], [7, 2], [7, 3], [6, 3]]
[numerics]
spacing = 0.25
threads = 1
wall = "slip"
[run]
duration = 0.3
)";
constexpr std::array<std::string_view, 7> places{"dam",  "body 1", "body 2", "apex",
                                                 "gate", "staff",  "pool"};

std::string without_place(const std::string& column) {
  for (const std::string_view place : places)
    if (column.starts_with(std::string(place) + ' ')) return column.substr(place.size() + 1);
  return column;
}

/// The columns of a table but the time, which all have.
Names columns_of(const FinishedRun& run, const std::string& file) {
  const std::string text = run.text_of("series/" + file);
  std::string_view lines = text;
  Names columns;
  for (const std::string& column : next_csv_line(lines).value_or(std::vector<std::string>{}))
    columns.insert(without_place(column));
  EXPECT_EQ(columns.erase("time [s]"), 1u) << file;
  return columns;
}

Names files_in(const std::filesystem::path& folder) {
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

/// What stands between backticks.
Names quoted_in(const std::string& text) {
  Names names;
  std::istringstream parts(text);
  bool is_quoted = false;
  for (std::string part; std::getline(parts, part, '`'); is_quoted = !is_quoted)
    if (is_quoted) names.insert(part);
  return names;
}

/// Of the tables of the page: the names in second cells, by those in the first cells of their rows.
std::map<std::string, Names> rows_of_page() {
  std::map<std::string, Names> rows;
  std::ifstream page(repository() / "docs" / "outputs.md");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with('|')) continue;
    std::istringstream cells(line.substr(1));
    std::string first, second;
    std::getline(cells, first, '|');
    std::getline(cells, second, '|');
    for (const std::string& name : quoted_in(first)) rows[name].merge(quoted_in(second));
  }
  return rows;
}

TEST(OutputsPage, HasEveryMapAndEveryColumnOfARun) {
  const TemporaryFolder folder;
  folder.write("case.toml", measured_channel);
  const FinishedRun run = run_to_end(folder / "case.toml", folder / "run", {});
  ASSERT_EQ(run.result.end, RunEnd::finished) << run.result.reason;
  const std::map<std::string, Names> page = rows_of_page();
  const Names maps = files_in(run.folder / "maps"), tables = files_in(run.folder / "series");
  ASSERT_GT(maps.size(), 10u);
  ASSERT_GT(tables.size(), 10u);
  for (const std::string& map : maps) EXPECT_TRUE(page.contains(map)) << map;
  for (const std::string& table : tables) {
    const auto row = page.find(table);
    EXPECT_EQ(row == page.end() ? Names{} : row->second, columns_of(run, table)) << table;
  }
  for (const auto& [name, columns] : page) {
    const bool is_map = name.ends_with(".tif"), is_table = name.ends_with(".csv");
    EXPECT_TRUE(!is_map || maps.contains(name)) << name << " is not there";
    EXPECT_TRUE(!is_table || tables.contains(name)) << name << " is not there";
  }
}

}  // namespace
}  // namespace sabo
