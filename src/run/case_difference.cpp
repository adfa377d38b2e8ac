#include "run/case_difference.hpp"

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "io/case_file/listing.hpp"

namespace sabo {
namespace {

/// Visitor of a case that takes the folders off the files its keys name.
class FolderDropper {
 public:
  template <class T>
  void operator()(const Key& /*key*/, T& member) {
    if constexpr (std::is_same_v<T, std::filesystem::path>) member = member.filename();
    if constexpr (std::is_same_v<T, LineSource>) member.file = member.file.filename();
  }
  template <class T>
  void table(std::string_view /*name*/, std::string_view /*help*/, T& member) {
    member.describe(*this);
  }
  template <class T>
  void tables(std::string_view /*name*/, std::string_view /*help*/, std::vector<T>& members) {
    for (T& member : members) member.describe(*this);
  }
};

using ListedValues = std::vector<std::pair<std::string, std::string>>;  // key, value

ListedValues values_of(Case c) {
  c.describe(FolderDropper());
  ListedValues values;
  std::map<std::string, int> counts;
  for (const ListedTable& table : list_tables(c)) {
    if (!table.is_given) continue;
    std::string prefix = table.name;
    if (table.is_list) prefix += fmt::format("[{}]", ++counts[table.name]);
    if (!prefix.empty()) prefix += '.';
    for (const ListedKey& key : table.keys) values.emplace_back(prefix + key.name, key.value);
  }
  return values;
}

ListedValues::const_iterator find_value(const ListedValues& values, const std::string& key) {
  return std::ranges::find(values, key, [](const auto& value) { return value.first; });
}

std::string value_in(const ListedValues& values, const std::string& key) {
  const auto found = find_value(values, key);
  return found == values.end() ? "" : found->second;
}

}  // namespace

std::vector<KeyDifference> case_differences(Case before, Case after) {
  const ListedValues old_values = values_of(std::move(before)),
                     values = values_of(std::move(after));
  std::vector<KeyDifference> differences;
  for (const auto& [key, value] : values)
    if (const std::string old_value = value_in(old_values, key); old_value != value)
      differences.push_back({key, old_value, value});
  for (const auto& [key, value] : old_values) {
    const bool is_there = find_value(values, key) != values.end();
    if (!is_there && !value.empty()) differences.push_back({key, value, ""});
  }
  return differences;
}

}  // namespace sabo
