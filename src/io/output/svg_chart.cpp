#include "io/output/svg_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "io/output/chart_axis.hpp"
#include "io/output/svg.hpp"

namespace sabo {
namespace {

// Okabe and Ito (2008), without black and yellow, which do not stand out as thin lines.
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

constexpr double margin_top = 78;
constexpr double margin_bottom = 52;
constexpr double margin_left = 16;
constexpr double margin_right = 24;
constexpr double tick_size = 12;
constexpr double name_size = 13;
constexpr double legend_line = 20;  // height of a line of the legend

constexpr std::array dashes{"", "8 5", "2 4", "12 4 2 4", "16 4", "5 3"};

std::string dash_attribute(const ChartStyle& style) {
  return *style.dashes == 0 ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dashes);
}

struct Range {
  bool is_log = false;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void hold(double value) {
    if (!std::isfinite(value) || (is_log && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return low > high; }
};

// An axis over the data, or over the limits where they are given.
ChartAxis axis_over(Range range, std::optional<double> low, std::optional<double> high, int count) {
  if (range.is_empty()) range = {range.is_log, range.is_log ? 1.0 : 0.0, range.is_log ? 10.0 : 1.0};
  if (range.is_log && low && !(*low > 0)) low.reset();
  if (range.is_log && high && !(*high > 0)) high.reset();
  const double from = low.value_or(range.low), to = high.value_or(range.high);
  return range.is_log ? log_axis(from, to, count) : linear_axis(from, to, count);
}

// The plot area and the scales that map data to it.
struct Axes {
  ChartAxis x_axis, y_axis;
  double left = 0, right = 0, top = 0, bottom = 0;
  double page_height = 0;

  double x(double value) const { return left + x_axis.share(value) * (right - left); }
  double y(double value) const { return bottom - y_axis.share(value) * (bottom - top); }
};

Axes axes_of(const LineChart& chart, double legend_height) {
  Range x{chart.x_log}, y{chart.y_log};
  for (const ChartSeries& series : chart.series) {
    for (double value : series.x) x.hold(value);
    for (double value : series.y) y.hold(value);
  }
  for (const ChartReference& line : chart.references) y.hold(line.y);
  for (const ChartMark& mark : chart.marks)
    if (mark.high) y.hold(*mark.high);
  if (y.is_empty() && !y.is_log) y.hold(1);
  if (chart.has_zero) y.hold(0);  // no effect on a logarithmic axis
  Axes axes{axis_over(x, chart.x_low, chart.x_high, 8), axis_over(y, chart.y_low, chart.y_high, 5)};
  double widest = 0;
  for (const AxisTick& tick : axes.y_axis.ticks) {
    widest = std::max(widest, text_width(tick.label, tick_size));
  }
  axes.page_height = chart.height + legend_height;
  axes.left = std::max(44.0, widest + 24);
  axes.right = chart.width - margin_right;
  axes.top = margin_top + legend_height;
  axes.bottom = axes.page_height - margin_bottom;
  return axes;
}

std::string draw_axes(const LineChart& chart, const Axes& axes) {
  constexpr const char* faint = "#f1f3f5";
  std::string svg;
  for (double value : axes.y_axis.minor) {
    svg += svg_line(axes.left, axes.y(value), axes.right, axes.y(value), faint, 1);
  }
  for (double value : axes.x_axis.minor) {
    svg += svg_line(axes.x(value), axes.top, axes.x(value), axes.bottom, faint, 1);
  }
  for (const AxisTick& tick : axes.y_axis.ticks) {
    const double y = axes.y(tick.value);
    const bool is_base = std::abs(tick.value) < 1e-9 * (axes.y_axis.high - axes.y_axis.low);
    svg += svg_line(axes.left, y, axes.right, y, is_base ? "#9aa5b1" : svg_light, 1);
    svg += svg_text(axes.left - 8, y + 4, tick.label, {.size = tick_size, .anchor = Anchor::end});
  }
  for (const AxisTick& tick : axes.x_axis.ticks) {
    const double x = axes.x(tick.value);
    svg += svg_line(x, axes.top, x, axes.bottom, svg_light, 1);
    svg += svg_line(x, axes.bottom, x, axes.bottom + 5, "#9aa5b1", 1);
    svg += svg_text(x, axes.bottom + 20, tick.label, {.size = tick_size, .anchor = Anchor::middle});
  }
  svg += svg_text((axes.left + axes.right) / 2, axes.page_height - 12, chart.x_title,
                  {.size = 13, .anchor = Anchor::middle});
  svg += svg_text(margin_left, axes.top - 20, chart.y_title, {.size = 13});
  svg += svg_text(margin_left, 30, chart.title, {.size = 17, .colour = svg_ink, .bold = true});
  return svg;
}

std::string draw_series(const ChartSeries& series, const ChartStyle& style, const Axes& axes) {
  std::string path;
  std::string dots;
  std::string last;
  bool is_down = false;
  const std::size_t count = std::min(series.x.size(), series.y.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (!axes.x_axis.can_show(series.x[i]) || !axes.y_axis.can_show(series.y[i])) {
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
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{} stroke-linejoin=\"round\" "
        "stroke-linecap=\"round\"/>\n",
        path, style.colour, dash_attribute(style));
  }
  if (series.has_markers && !dots.empty()) {
    svg += fmt::format("<g fill=\"{}\" stroke=\"#ffffff\">{}</g>\n", style.colour, dots);
  }
  return svg;
}

std::string draw_references(const LineChart& chart, const Axes& axes) {
  std::string svg;
  for (const ChartReference& line : chart.references) {
    if (!axes.y_axis.can_show(line.y)) continue;
    const double y = axes.y(line.y);
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"1.2\" stroke-dasharray=\"6 4\"/>\n",
        axes.left, y, axes.right, y, svg_muted);
    svg += svg_text(axes.right - 4, y - 6, line.label,
                    {.size = tick_size, .anchor = Anchor::end, .halo = true});
  }
  return svg;
}

// Labels in three lines in turn, so that neighbours do not cover each other.
std::string draw_marks(const LineChart& chart, const Axes& axes) {
  std::string svg;
  for (std::size_t k = 0; k < chart.marks.size(); ++k) {
    const ChartMark& mark = chart.marks[k];
    if (!axes.x_axis.can_show(mark.x)) continue;
    const double x = axes.x(mark.x);
    if (x < axes.left - 0.5 || x > axes.right + 0.5) continue;
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" stroke=\"{3}\" "
        "stroke-dasharray=\"2 3\"/>\n",
        x, axes.top, axes.bottom, svg_muted);
    if (mark.low && mark.high)
      svg += svg_line(x, axes.y(*mark.low), x, axes.y(*mark.high), "#c1121f", 5);
    const bool is_right = x > axes.left + 0.7 * (axes.right - axes.left);
    svg += svg_text(x + (is_right ? -4 : 4), axes.top + 12 + 14 * static_cast<double>(k % 3),
                    mark.label,
                    {.size = tick_size,
                     .colour = svg_ink,
                     .anchor = is_right ? Anchor::end : Anchor::start,
                     .halo = true});
  }
  return svg;
}

// Where the name of a series stands.
struct LegendPlace {
  double x = 0;
  int line = 0;  // 0: the line of the y title
};

constexpr double legend_key = 22, legend_gap = 7, legend_between = 20;

double legend_width(const ChartSeries& series) {
  return legend_key + legend_gap + text_width(series.name, name_size) + legend_between;
}

// Names of the series at the right end of the line of the y title; if they do not fit beside it, on
// lines of their own above it, from left to right. One series needs no legend.
std::vector<LegendPlace> legend_of(const LineChart& chart) {
  if (chart.series.size() < 2) return {};
  const double right = chart.width - margin_right;
  double whole = -legend_between;
  for (const ChartSeries& series : chart.series) whole += legend_width(series);
  const double title_end = margin_left + text_width(chart.y_title, 13) + legend_between;
  const bool is_beside = right - whole >= title_end;
  LegendPlace place{is_beside ? right - whole : margin_left, is_beside ? 0 : 1};
  std::vector<LegendPlace> places;
  for (const ChartSeries& series : chart.series) {
    const double width = legend_width(series);
    if (!is_beside && place.x > margin_left && place.x + width - legend_between > right) {
      place = {margin_left, place.line + 1};
    }
    places.push_back(place);
    place.x += width;
  }
  return places;
}

std::string draw_legend(const LineChart& chart, const std::vector<LegendPlace>& places) {
  std::string svg;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const ChartSeries& series = chart.series[k];
    const ChartStyle style = chart_style(chart, k);
    const double x = places[k].x;
    const double baseline = 58 + legend_line * std::max(places[k].line - 1, 0);
    const double y = baseline - 4.5;
    if (series.has_line) {
      svg += fmt::format(
          "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
          "stroke-width=\"3\"{}/>\n",
          x, y, x + legend_key, y, style.colour, dash_attribute(style));
    }
    if (series.has_markers) {
      // On the first dash of a line: in its middle it would hide the gap.
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{}\" r=\"3.5\" fill=\"{}\"/>\n",
                         series.has_line ? x + 4 : x + legend_key - 4, y, style.colour);
    }
    svg += svg_text(x + legend_key + legend_gap, baseline, series.name,
                    {.size = name_size, .colour = svg_ink});
  }
  return svg;
}

}  // namespace

ChartStyle chart_style(const LineChart& chart, std::size_t series) {
  const std::size_t round = series / palette.size();
  return {palette[series % palette.size()],
          dashes[chart.has_dashes ? (series + round) % dashes.size() : round % 2]};
}

std::string chart_svg(const LineChart& chart) {
  const std::vector<LegendPlace> legend = legend_of(chart);
  const Axes axes = axes_of(chart, legend.empty() ? 0 : legend_line * legend.back().line);
  std::string svg = svg_begin(chart.width, axes.page_height, chart.title);
  svg += draw_axes(chart, axes);
  svg += fmt::format(
      "<clipPath id=\"{0}plot\"><rect x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
      "height=\"{4:.1f}\"/></clipPath>\n<g clip-path=\"url(#{0}plot)\">\n",
      chart.id, axes.left, axes.top - 4, axes.right - axes.left + 4, axes.bottom - axes.top + 8);
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    svg += draw_series(chart.series[k], chart_style(chart, k), axes);
  }
  svg += "</g>\n" + draw_references(chart, axes) + draw_marks(chart, axes) +
         draw_legend(chart, legend);
  return svg + "</svg>\n";
}

}  // namespace sabo
