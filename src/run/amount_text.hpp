#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace sabo {

/// A volume, length or force of any size: whole numbers from 100 on, else three digits that matter.
inline std::string amount_text(double amount) {
  return std::abs(amount) >= 100 ? fmt::format("{:.0f}", amount) : fmt::format("{:.3g}", amount);
}

}  // namespace sabo
