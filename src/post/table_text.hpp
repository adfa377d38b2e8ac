#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace sabo {

/// A number for a table: `digits` significant digits at most; "-" for one that is not finite.
inline std::string table_number(double value, int digits = 6) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);  // no negative zero
}

}  // namespace sabo
