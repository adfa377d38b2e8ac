#include "io/case_file/check_parts.hpp"

#include <cmath>

namespace sabo {

double plan_length(const LineSource& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.coordinates.size(); ++i) {
    const auto& a = line.coordinates[i - 1];
    const auto& b = line.coordinates[i];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

void check_line(const LineSource& line, const std::string& key, Faults& faults) {
  if (!line.coordinates.empty() && !(plan_length(line) > 0)) {
    faults.add(key, "all its points are at one place", "give a line of some length");
  }
}

void check_polygon(const LineSource& polygon, const std::string& key, Faults& faults) {
  check_line(polygon, key, faults);
  const std::size_t corners = polygon.coordinates.size();
  if (corners > 0 && corners < 3) {
    faults.add(key, "has fewer than three points", "give three or more");
  }
}

void check_keys(std::span<const KeyRule> rules, std::string_view kind, const std::string& path,
                Faults& faults) {
  for (const KeyRule& rule : rules) {
    const std::string key = fmt::format("{}.{}", path, rule.key);
    if (faults.has(key)) continue;
    if (rule.is_given && !rule.applies) {
      faults.add(key, fmt::format("does not apply to kind \"{}\"", kind), "remove it");
    } else if (!rule.is_given && rule.applies && rule.is_needed) {
      faults.add(key, "is missing", rule.remedy);
    }
  }
}

}  // namespace sabo
