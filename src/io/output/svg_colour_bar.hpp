#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/output/colour_scale.hpp"

namespace sabo {

/// The colours of flow_colour from 0 to `top` (> 0) as a bar of 300 x 12 px with its corner at
/// (x, y), the quantity above it and values below. It needs 25 px above y and 30 px below.
/// `id` tells it apart from others in one page.
std::string svg_colour_bar(double x, double y, std::string_view quantity, double top,
                           std::string_view id = "");

/// The classes of a stepped scale side by side, each as wide as its label below, in the same place.
std::string svg_step_bar(double x, double y, std::string_view quantity,
                         std::span<const ColourStep> steps);

/// Width of that bar, pixels.
double step_bar_width(std::span<const ColourStep> steps);

}  // namespace sabo
