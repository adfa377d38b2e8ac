#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/faults.hpp"
#include "case/line_source.hpp"

namespace sabo {

// Rules that several tables of the case have in common.

/// Length in plan of a line given by coordinates, m.
double plan_length(const LineSource& line);

/// A line given by coordinates has some length.
void check_line(const LineSource& line, const std::string& key, Faults& faults);

/// A polygon given by coordinates has three corners at least.
void check_polygon(const LineSource& polygon, const std::string& key, Faults& faults);

/// A key, whether it is given, and whether the kind of thing that has it can have it and needs it.
struct KeyRule {
  const char* key;
  bool is_given;
  bool applies;
  bool is_needed = false;
  const char* remedy = "give it";
};

/// Adds a fault for each key of the table `path` that its kind cannot have or lacks.
void check_keys(std::span<const KeyRule> rules, std::string_view kind, const std::string& path,
                Faults& faults);

/// Names stand for their owners in the outputs.
template <class T>
void check_names(const std::vector<T>& members, const std::string& table, Faults& faults) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto [earlier, is_new] = first.emplace(members[i].name, i);
    if (is_new) continue;
    faults.add(fmt::format("{}[{}].name", table, i + 1),
               fmt::format("\"{}\" is the name of {}[{}] too", members[i].name, table,
                           earlier->second + 1),
               "give each its own name");
  }
}

}  // namespace sabo
