#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "report/report_parts.hpp"

#include "io/output/read_file.hpp"

namespace sabo {
namespace {

constexpr const char* force_x = " force x [N]";
constexpr const char* profiles_file = "series/pressure_profiles.csv";
constexpr std::size_t max_profiles = 100'000'000;  // bytes

/// Size of the horizontal force on a body over time, kN.
ChartSeries horizontal_force(const Report& report, const NumberTable& table,
                             const std::string& body) {
  ChartSeries series = over_time(table, body + force_x, report.say("load.computed"), 1e-3);
  const std::vector<double>* along_y = table.find(body + " force y [N]");
  for (std::size_t k = 0; along_y && k < series.y.size(); ++k)
    series.y[k] = std::hypot(series.y[k], (*along_y)[k] / 1000);
  return series;
}

/// Horizontal part of a vector of [[load]].
std::optional<double> horizontal(const TomlTable& load, std::string_view key) {
  const TomlNode* node = find(load, key);
  const auto* vector = node ? std::get_if<TomlArray>(&node->value) : nullptr;
  if (!vector || vector->size() != 3) return std::nullopt;
  const auto component = [&](std::size_t k) {
    const TomlTable one{{"value", (*vector)[k]}};
    return number_at(one, "value").value_or(0);
  };
  return std::hypot(component(0), component(1));
}

struct LoadColumn {
  const char* key;    ///< of [[load]]
  const char* label;  ///< of the texts
  double scale;       ///< from the file's unit to that of the label
  bool is_vector = false;
};
constexpr std::array load_columns{LoadColumn{"peak_force", "load.peak", 1e-3},
                                  LoadColumn{"peak_time", "load.time", 1},
                                  LoadColumn{"filter", "load.filter", 1},
                                  LoadColumn{"row_moment", "load.moment", 1e-3, true},
                                  LoadColumn{"impulse", "load.impulse", 1e-3, true},
                                  LoadColumn{"hydrostatic", "load.hydrostatic", 1e-3},
                                  LoadColumn{"dynamic", "load.dynamic", 1e-3},
                                  LoadColumn{"alpha", "load.alpha", 1}};

void add_peak_table(Report& report) {
  ReportTable table;
  table.caption = report.say("load.peaks");
  table.header = {report.say("load.body")};
  for (const LoadColumn& column : load_columns) table.header.push_back(report.say(column.label));
  for (const TomlTable& load : report.run.list("load")) {
    table.rows.push_back({text_at(load, "name").value_or("–")});
    for (const LoadColumn& column : load_columns) {
      auto value = column.is_vector ? horizontal(load, column.key) : number_at(load, column.key);
      if (value) *value *= column.scale;
      table.rows.back().push_back(amount_or_dash(value));
    }
  }
  table.source = data_line(report, {"manifest.toml [[load]]"});
  report.page.table(table);
}

/// The formulas of design over time where the run has them, else their values at the peak.
void add_design(const Report& report, const NumberTable& table, const std::string& body,
                LineChart& chart) {
  for (const auto& [column, key, label] :
       {std::array{" hydrostatic [N]", "hydrostatic", "load.hydrostatic_line"},
        {" dynamic [N]", "dynamic", "load.dynamic_line"}}) {
    if (table.find(body + column)) {
      chart.series.push_back(over_time(table, body + column, report.say(label), 1e-3));
      continue;
    }
    for (const TomlTable& load : report.run.list("load")) {
      const auto force = number_at(load, key);
      if (force && text_at(load, "name") == body)
        chart.references.push_back({*force / 1000, report.say(label)});
    }
  }
}

/// Greatest pressure over the run (kPa) by the elevation of the middle of a layer (m).
using Envelope = std::map<double, double>;

std::vector<std::pair<std::string, Envelope>> pressure_envelopes(const RunRecord& run) {
  std::vector<std::pair<std::string, Envelope>> envelopes;
  const auto content = read_file(run.folder() / profiles_file, max_profiles);
  if (!content) return envelopes;
  std::string_view rest = *content;
  const auto header = next_csv_line(rest);
  const std::vector<std::string> wanted{"structure", "time [s]",     "bottom [m]",
                                        "top [m]",   "force x [N]",  "force y [N]",
                                        "width [m]", "pressure [Pa]"};
  if (header != wanted) return envelopes;
  rest = rest.substr(0, rest.rfind('\n') + 1);
  while (!rest.empty()) {
    const auto fields = next_csv_line(rest);
    if (!fields || fields->size() != wanted.size()) break;
    const double middle = (number_of_field((*fields)[2]) + number_of_field((*fields)[3])) / 2;
    const double pressure = number_of_field((*fields)[7]) / 1000;
    if (!std::isfinite(middle) || !std::isfinite(pressure)) continue;
    auto body =
        std::ranges::find(envelopes, fields->front(), &decltype(envelopes)::value_type::first);
    if (body == envelopes.end()) body = envelopes.insert(body, {fields->front(), {}});
    double& greatest = body->second.try_emplace(middle, pressure).first->second;
    greatest = std::max(greatest, pressure);
  }
  return envelopes;
}

void add_profiles(Report& report) {
  LineChart chart{report.say("load.profile"), report.say("axis.elevation"),
                  report.say("axis.pressure")};
  for (const auto& [body, envelope] : pressure_envelopes(report.run)) {
    ChartSeries series{body};
    for (const auto& [elevation, pressure] : envelope) {
      series.x.push_back(elevation);
      series.y.push_back(pressure);
    }
    series.has_markers = true;
    chart.series.push_back(series);
  }
  if (!chart.series.empty()) report.page.chart(chart, data_line(report, {profiles_file}));
}

}  // namespace

void add_loads(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const bool has_series = run.has("series/loads.csv");
  const NumberTable* table = has_series ? run.series("loads.csv") : nullptr;
  const bool has_bodies = table && table->names.size() > 1;
  if (!has_bodies && run.list("load").empty()) return;
  page.section(say("load.title"));
  page.text(say("load.about"));
  add_peak_table(report);
  if (!has_bodies) return tell_missing(report, "series/loads.csv");
  for (const std::string& body : names_before(*table, force_x)) {
    LineChart chart{say("load.chart", body), say("axis.time"), say("axis.force")};
    chart.series = {horizontal_force(report, *table, body)};
    add_design(report, *table, body, chart);
    page.chart(chart, data_line(report, {"series/loads.csv"}));
  }
  add_profiles(report);
}

}  // namespace sabo
