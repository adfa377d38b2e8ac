#pragma once

#include <string>
#include <string_view>

namespace sabo {

/// The colours of flow_colour from 0 to `top` (> 0) as a bar of 300 x 12 px with its corner at
/// (x, y), the quantity above it and values below. It needs 25 px above y and 30 px below.
std::string svg_colour_bar(double x, double y, std::string_view quantity, double top);

}  // namespace sabo
