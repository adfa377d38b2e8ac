#include "post/series_charts.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "io/output/svg_chart.hpp"

namespace sabo {
namespace {

/// Which columns of a series are drawn: those whose name has one of these endings.
struct ChartedSeries {
  const char* file;
  std::vector<std::string_view> endings;  ///< before the unit
};

const std::vector<ChartedSeries>& charted() {
  static const std::vector<ChartedSeries> list{
      {"front", {"displacement", "velocity"}},
      {"discharge", {"net discharge"}},
      {"sections", {"area", "greatest depth", "mean speed"}},
      {"gauges", {"depth", "speed", "pressure"}},
      {"volumes", {"outflow", "trapped", "beyond"}},
      {"filling", {"stored"}},
      {"loads", {"force x", "force y", "force z"}}};
  return list;
}

/// "p1 net discharge" of "p1 net discharge [m3/s]".
std::string_view without_unit(std::string_view label) { return label.substr(0, label.rfind(" [")); }

std::string_view unit_of(std::string_view label) {
  const std::size_t at = label.rfind(" [");
  return at == std::string_view::npos ? "" : label.substr(at + 1);
}

bool is_drawn(std::string_view label, const ChartedSeries& series) {
  const std::string_view name = without_unit(label);
  return std::ranges::any_of(series.endings,
                             [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

std::vector<PairedChart> paired_charts(const FinishedRun& a, const FinishedRun& b,
                                       const std::vector<std::string>& names) {
  std::vector<PairedChart> charts;
  for (const ChartedSeries& series : charted()) {
    const auto first = a.series(series.file), second = b.series(series.file);
    if (!first || !second) continue;
    const std::vector<double>* first_time = first->find("time [s]");
    const std::vector<double>* second_time = second->find("time [s]");
    if (!first_time || !second_time) continue;
    for (std::size_t k = 0; k < first->names.size(); ++k) {
      const std::string& label = first->names[k];
      const std::vector<double>* other = second->find(label);
      if (!other || !is_drawn(label, series)) continue;
      LineChart chart;
      chart.title = series.file == std::string_view("front")
                        ? fmt::format("Front: {}", without_unit(label))
                        : std::string(without_unit(label));
      chart.x_title = "time [s]";
      chart.y_title = fmt::format("{} {}", without_unit(label), unit_of(label));
      chart.series = {{"a: " + names[0], *first_time, first->columns[k]},
                      {"b: " + names[1], *second_time, *other}};
      charts.push_back({fmt::format("{}_{:02}.svg", series.file, k), chart_svg(chart),
                        fmt::format("{} (series/{}.csv of both runs)", label, series.file)});
    }
  }
  return charts;
}

}  // namespace sabo
