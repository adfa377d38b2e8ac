#include "io/output/svg_colour_bar.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/output/colour_scale.hpp"
#include "io/output/svg.hpp"
#include "io/output/ticks.hpp"

namespace sabo {
namespace {

double step_width(const ColourStep& step) {
  return std::max(72.0, text_width(step.label, TextStyle{}.size) + 14);
}

}  // namespace

std::string svg_colour_bar(double x, double y, std::string_view quantity, double top,
                           std::string_view id) {
  constexpr double width = 300, height = 12;
  std::string stops;
  for (int i = 0; i <= 8; ++i) {
    stops +=
        fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>", i / 8.0, hex(flow_colour(i / 8.0)));
  }
  std::string svg = fmt::format(
      "<linearGradient id=\"{0}scale\">{1}</linearGradient>\n<rect x=\"{2}\" y=\"{3}\" "
      "width=\"{4}\" height=\"{5}\" fill=\"url(#{0}scale)\"/>\n",
      id, stops, x, y, width, height);
  svg += svg_text(x, y - 8, quantity, {.size = 13, .colour = svg_ink});
  const Ticks ticks = ticks_over(0, top, 5);
  for (double value : ticks.values) {
    if (value > top * (1 + 1e-9)) continue;
    const double place = x + width * value / top;
    svg += svg_line(place, y + height, place, y + height + 4, svg_muted, 1);
    svg += svg_text(place, y + height + 17, ticks.label(value), {.anchor = Anchor::middle});
  }
  return svg;
}

std::string svg_step_bar(double x, double y, std::string_view quantity,
                         std::span<const ColourStep> steps) {
  constexpr double height = 12;
  std::string svg = svg_text(x, y - 8, quantity, {.size = 13, .colour = svg_ink});
  double left = x;
  for (const ColourStep& step : steps) {
    const double width = step_width(step);
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\" "
        "stroke=\"{}\"/>\n",
        left, y, width, height, hex(step.colour), svg_muted);
    svg += svg_text(left + width / 2, y + height + 17, step.label, {.anchor = Anchor::middle});
    left += width;
  }
  return svg;
}

double step_bar_width(std::span<const ColourStep> steps) {
  double width = 0;
  for (const ColourStep& step : steps) width += step_width(step);
  return width;
}

}  // namespace sabo
