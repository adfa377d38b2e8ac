#pragma once

#include <numbers>

namespace sabo {

/// One degree, rad.
inline constexpr double degree = std::numbers::pi / 180;

}  // namespace sabo
