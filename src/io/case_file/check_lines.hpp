#pragma once

#include <string>

#include "base/faults.hpp"
#include "case/line_source.hpp"

namespace sabo {

/// Length in plan of a line given by coordinates, m; 0 for one from a file.
double plan_length(const LineSource& line);

/// Adds a fault at `key` for coordinates that make no line.
void check_line(const LineSource& line, const std::string& key, Faults& faults);

/// Adds a fault at `key` for coordinates that make no polygon.
void check_polygon(const LineSource& polygon, const std::string& key, Faults& faults);

}  // namespace sabo
