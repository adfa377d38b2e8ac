// Every key that a case may have, with every kind of value that it may not have.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "case_file/support.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_file/listing.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

/// The smallest case, table by table, with one line more in the table of that name.
std::string with_line(const ListedTable& table, const std::string& key, const std::string& line) {
  struct Part {
    std::string table;
    std::vector<std::string> lines;
  };
  std::vector<Part> parts{{"", {}},
                          {"terrain", {"dem = \"dem.tif\""}},
                          {"release", {"polygon = \"release.gpkg\"", "volume = 100"}},
                          {"run", {"duration = 10"}},
                          {"numerics", {"spacing = 0.5"}}};
  auto part = std::ranges::find(parts, table.name, &Part::table);
  std::string text;
  if (part != parts.end()) {
    std::erase_if(part->lines, [&](const std::string& old) { return old.starts_with(key + " ="); });
    part->lines.push_back(line);
  }
  for (const Part& each : parts) {
    if (!each.table.empty()) text += "[" + each.table + "]\n";
    for (const std::string& each_line : each.lines) text += each_line + "\n";
  }
  if (part != parts.end()) return text;
  // A table within a list needs an entry of the list, as notches need a structure.
  const std::string parent = table.name.substr(0, table.name.find('.'));
  const bool is_nested = parent != table.name;
  for (const ListedTable& other : list_tables({}))
    if (is_nested && other.name == parent && other.is_list) text += "[[" + parent + "]]\n";
  return text + (table.is_list ? "[[" + table.name + "]]\n" : "[" + table.name + "]\n") + line +
         "\n";
}

/// Calls visit(table, key) for all of them; of the rheologies those of the default.
template <class Visit>
void for_each_key(const Visit& visit) {
  for (const ListedTable& table : list_tables({}))
    for (const ListedKey& key : table.keys) visit(table, key.name);
}

std::vector<Fault> faults_of(const std::string& text) {
  Faults faults;
  read_case_text(text, folder_with_files(), faults);
  return faults.list();
}

TEST(EveryKey, RefusesValuesOfAnotherKind) {
  int tried = 0;
  for_each_key([&](const ListedTable& table, const std::string& key) {
    for (const char* value : {"nan", "-inf", "{}", "[[[]]]", "2010-10-20T12:00:00Z", "1e300",
                              "-9223372036854775808", "\"\\u0007\""}) {
      const std::string text = with_line(table, key, key + " = " + value);
      const std::vector<Fault> faults = faults_of(text);
      ++tried;
      EXPECT_TRUE(std::ranges::any_of(faults, [&](const Fault& fault) {
        return to_string(fault).find(key) != std::string::npos;
      })) << text;
      for (const Fault& fault : faults)
        EXPECT_FALSE(fault.place.empty() || fault.problem.empty() || fault.remedy.empty())
            << to_string(fault);
    }
  });
  EXPECT_GT(tried, 1000);
  std::printf("%d values tried\n", tried);
}

TEST(EveryKey, IsMissedWhenMisspelt) {
  for_each_key([](const ListedTable& table, const std::string& key) {
    const std::string wrong = key + "x";
    std::string all;
    for (const Fault& fault : faults_of(with_line(table, key, wrong + " = 1")))
      all += to_string(fault) + "\n";
    EXPECT_THAT(all, HasSubstr(wrong + ": unknown key; did you mean \"")) << table.name;
  });
}

}  // namespace
}  // namespace sabo
