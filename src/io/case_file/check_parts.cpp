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

}  // namespace sabo
