#include "io/output/svg_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "io/output/svg.hpp"
#include "io/output/ticks.hpp"

namespace sabo {
namespace {

// Okabe and Ito (2008), without black and yellow, which do not stand out as thin lines.
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

constexpr double margin_top = 78;
constexpr double margin_bottom = 52;
constexpr double margin_right = 24;
constexpr double label_size = 12;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void hold(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return low > high; }
};

// The plot area and the scales that map data to it.
struct Axes {
  Ticks x_ticks, y_ticks;
  double x_low = 0, x_high = 1;
  double left = 0, right = 0, top = 0, bottom = 0;

  double x(double value) const {
    return left + (value - x_low) / (x_high - x_low) * (right - left);
  }
  double y(double value) const {
    return bottom - (value - y_ticks.first()) / (y_ticks.last() - y_ticks.first()) * (bottom - top);
  }
};

Axes axes_of(const LineChart& chart) {
  Range x, y;
  for (const ChartSeries& series : chart.series) {
    for (double value : series.x) x.hold(value);
    for (double value : series.y) y.hold(value);
  }
  for (const ChartReference& line : chart.references) y.hold(line.y);
  if (x.is_empty()) x = {0, 1};
  if (y.is_empty()) y = {0, 1};
  y.hold(0);
  Axes axes;
  axes.y_ticks = ticks_over(chart.y_low.value_or(y.low), chart.y_high.value_or(y.high), 5);
  axes.x_ticks = ticks_over(chart.x_low.value_or(x.low), chart.x_high.value_or(x.high), 8);
  axes.x_low = axes.x_ticks.first();
  axes.x_high = axes.x_ticks.last();
  double widest = 0;
  for (double tick : axes.y_ticks.values) {
    widest = std::max(widest, text_width(axes.y_ticks.label(tick), label_size));
  }
  axes.left = std::max(44.0, widest + 24);
  axes.right = chart.width - margin_right;
  axes.top = margin_top;
  axes.bottom = chart.height - margin_bottom;
  return axes;
}

std::string draw_axes(const LineChart& chart, const Axes& axes) {
  std::string svg;
  for (double tick : axes.y_ticks.values) {
    const double y = axes.y(tick);
    const bool is_base = std::abs(tick) < 1e-9 * axes.y_ticks.step;
    svg += svg_line(axes.left, y, axes.right, y, is_base ? "#9aa5b1" : svg_light, 1);
    svg += svg_text(axes.left - 8, y + 4, axes.y_ticks.label(tick),
                    {.size = label_size, .anchor = Anchor::end});
  }
  for (double tick : axes.x_ticks.values) {
    const double x = axes.x(tick);
    svg += svg_line(x, axes.top, x, axes.bottom, svg_light, 1);
    svg += svg_line(x, axes.bottom, x, axes.bottom + 5, "#9aa5b1", 1);
    svg += svg_text(x, axes.bottom + 20, axes.x_ticks.label(tick),
                    {.size = label_size, .anchor = Anchor::middle});
  }
  svg += svg_text((axes.left + axes.right) / 2, chart.height - 12, chart.x_title,
                  {.size = 13, .anchor = Anchor::middle});
  svg += svg_text(16, 58, chart.y_title, {.size = 13});
  svg += svg_text(16, 30, chart.title, {.size = 17, .colour = svg_ink, .bold = true});
  return svg;
}

std::string draw_series(const ChartSeries& series, const char* colour, const Axes& axes) {
  std::string path;
  std::string dots;
  std::string last;
  bool is_down = false;
  const std::size_t count = std::min(series.x.size(), series.y.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      is_down = false;
      continue;
    }
    const std::string place =
        fmt::format("{:.1f} {:.1f}", axes.x(series.x[i]), axes.y(series.y[i]));
    if (is_down && place == last) continue;  // keeps long series small
    path += (is_down ? "L" : "M") + place;
    dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>", axes.x(series.x[i]),
                        axes.y(series.y[i]));
    is_down = true;
    last = place;
  }
  std::string svg;
  if (series.has_line && !path.empty()) {
    svg += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\" "
        "stroke-linecap=\"round\"/>\n",
        path, colour);
  }
  if (series.has_markers && !dots.empty()) {
    svg += fmt::format("<g fill=\"{}\" stroke=\"#ffffff\">{}</g>\n", colour, dots);
  }
  return svg;
}

std::string draw_references(const LineChart& chart, const Axes& axes) {
  std::string svg;
  for (const ChartReference& line : chart.references) {
    const double y = axes.y(line.y);
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"1.2\" stroke-dasharray=\"6 4\"/>\n",
        axes.left, y, axes.right, y, svg_muted);
    svg += svg_text(axes.right - 4, y - 6, line.label,
                    {.size = label_size, .anchor = Anchor::end, .halo = true});
  }
  return svg;
}

// Names of the series, up to the right end of the line of the y title; one needs no legend.
std::string draw_legend(const LineChart& chart, const Axes& axes) {
  if (chart.series.size() < 2) return "";
  constexpr double key = 22, gap = 7, between = 20, y = 53.5;
  double x = axes.right + between;
  for (const ChartSeries& series : chart.series) {
    x -= key + gap + text_width(series.name, 13) + between;
  }
  std::string svg;
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const ChartSeries& series = chart.series[k];
    const char* colour = palette[k % palette.size()];
    if (series.has_line) svg += svg_line(x, y, x + key, y, colour, 3);
    if (series.has_markers) {
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{}\" r=\"3.5\" fill=\"{}\"/>\n",
                         series.has_line ? x + key / 2 : x + key - 4, y, colour);
    }
    svg += svg_text(x + key + gap, 58, series.name, {.size = 13, .colour = svg_ink});
    x += key + gap + text_width(series.name, 13) + between;
  }
  return svg;
}

}  // namespace

std::string chart_svg(const LineChart& chart) {
  const Axes axes = axes_of(chart);
  std::string svg = svg_begin(chart.width, chart.height, chart.title);
  svg += draw_axes(chart, axes);
  svg += fmt::format(
      "<clipPath id=\"plot\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>"
      "</clipPath>\n<g clip-path=\"url(#plot)\">\n",
      axes.left, axes.top - 4, axes.right - axes.left + 4, axes.bottom - axes.top + 8);
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    svg += draw_series(chart.series[k], palette[k % palette.size()], axes);
  }
  svg += "</g>\n" + draw_references(chart, axes) + draw_legend(chart, axes);
  return svg + "</svg>\n";
}

}  // namespace sabo
