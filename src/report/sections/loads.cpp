#include <algorithm>
#include <array>
#include <cmath>

#include "report/report_parts.hpp"
#include <fmt/format.h>

namespace sabo {
namespace {

constexpr const char* force_x = " force x [N]";

/// Size of the horizontal force on a body over time, kN.
ChartSeries horizontal_force(const SeriesTable& table, const std::string& body) {
  ChartSeries series = over_time(table, body + force_x, body, 1e-3);
  const std::vector<double>* along_y = table.find(body + " force y [N]");
  for (std::size_t k = 0; along_y && k < series.y.size(); ++k)
    series.y[k] = std::hypot(series.y[k], (*along_y)[k] / 1000);
  return series;
}

struct LoadColumn {
  const char* key;    ///< of [[load]]
  const char* label;  ///< of the texts
  double scale;       ///< from the file's unit to that of the label
};
constexpr std::array load_columns{
    LoadColumn{"peak_force", "load.peak", 1e-3}, LoadColumn{"peak_time", "load.time", 1},
    LoadColumn{"filter", "load.filter", 1}, LoadColumn{"hydrostatic", "load.hydrostatic", 1e-3},
    LoadColumn{"dynamic", "load.dynamic", 1e-3}};

void add_peak_table(Report& report) {
  const std::vector<TomlTable> loads = report.run.list("load");
  ReportTable table;
  table.caption = report.say("load.peaks");
  table.header = {report.say("load.body")};
  for (const LoadColumn& column : load_columns) table.header.push_back(report.say(column.label));
  for (const TomlTable& load : loads) {
    table.rows.push_back({text_at(load, "name").value_or("–")});
    for (const LoadColumn& column : load_columns) {
      auto value = number_at(load, column.key);
      if (value) *value *= column.scale;
      table.rows.back().push_back(amount_or_dash(value));
    }
  }
  table.source = data_line(report, {"manifest.toml [[load]]"});
  report.page.table(table);
}

/// What a run says of a load beyond the columns of the table, as it says it.
void add_other_values(Report& report) {
  ReportTable table;
  table.caption = report.say("load.more");
  table.header = {report.say("load.body"), report.say("parameter.key"), report.say("column.value")};
  for (const TomlTable& load : report.run.list("load"))
    for (const TomlEntry& entry : load) {
      const bool is_shown =
          entry.key == "name" || std::ranges::any_of(load_columns, [&](const LoadColumn& column) {
            return entry.key == column.key;
          });
      if (is_shown) continue;
      const auto number = number_at(load, entry.key);
      const auto text = text_at(load, entry.key);
      if (number || text)
        table.rows.push_back({text_at(load, "name").value_or("–"), entry.key,
                              number ? fmt::format("{:.6g}", *number) : *text});
    }
  table.source = data_line(report, {"manifest.toml [[load]]"});
  report.page.table(table);
}

std::vector<ChartReference> design_lines(const Report& report, const std::string& body) {
  std::vector<ChartReference> lines;
  for (const TomlTable& load : report.run.list("load")) {
    if (text_at(load, "name") != body) continue;
    for (const auto& [key, label] :
         {std::array{"hydrostatic", "load.hydrostatic_line"}, {"dynamic", "load.dynamic_line"}})
      if (const auto force = number_at(load, key))
        lines.push_back({*force / 1000, report.say(label)});
  }
  return lines;
}

}  // namespace

void add_loads(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const bool has_series = run.has("series/loads.csv");
  if (!has_series && run.list("load").empty()) return;
  page.section(say("load.title"));
  page.text(say("load.about"));
  add_peak_table(report);
  const SeriesTable* table = has_series ? run.series("loads.csv") : nullptr;
  if (!table) return tell_missing(report, "series/loads.csv");
  for (const std::string& body : names_before(*table, force_x)) {
    LineChart chart{say("load.chart", body), say("axis.time"), say("axis.force")};
    chart.series = {horizontal_force(*table, body)};
    chart.references = design_lines(report, body);
    page.chart(chart, data_line(report, {"series/loads.csv", "manifest.toml [[load]]"}));
  }
  add_other_values(report);
  if (run.has("series/pressure_profiles.csv"))
    page.source(data_line(report, {"series/pressure_profiles.csv"}));
}

}  // namespace sabo
