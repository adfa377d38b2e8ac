#include <algorithm>

#include "report/report_parts.hpp"

namespace sabo {
namespace {

constexpr const char* discharge = " net discharge [m3/s]";

std::optional<double> last_of(const NumberTable& table, const std::string& column) {
  const std::vector<double>* values = table.find(column);
  return values && !values->empty() ? std::optional(values->back()) : std::nullopt;
}

std::optional<double> passed(const NumberTable& table, const std::string& section) {
  const auto forward = last_of(table, section + " forward volume [m3]");
  const auto backward = last_of(table, section + " backward volume [m3]");
  return forward && backward ? std::optional(*forward - *backward) : std::nullopt;
}

/// The greatest of a column of sections.csv, "–" where a run does not measure it.
std::string greatest(const NumberTable* table, const std::string& column) {
  const auto peak = table ? peak_of(*table, column) : std::nullopt;
  return peak ? amount(peak->value) : "–";
}

void add_peak_table(Report& report, const NumberTable& table,
                    const std::vector<std::string>& sections) {
  const auto& [run, other, say, page, sharpness] = report;
  const NumberTable* flow = run.has("series/sections.csv") ? run.series("sections.csv") : nullptr;
  ReportTable peaks;
  peaks.caption = say("section.peaks");
  peaks.header = {say("column.section"), say("section.arrival"), say("section.peak"),
                  say("section.peak_time"), say("section.volume")};
  if (flow) {
    peaks.header.push_back(say("section.area"));
    peaks.header.push_back(say("section.depth"));
    peaks.header.push_back(say("section.mean_speed"));
    peaks.header.push_back(say("section.top_speed"));
  }
  for (const std::string& section : sections) {
    const auto peak = peak_of(table, section + discharge);
    auto arrival = run.quantity("arrival at section " + section + " [s]");  // see key_quantities()
    if (!arrival) arrival = run.quantity("arrival at " + section + " [s]");
    peaks.rows.push_back({section, arrival ? fixed(*arrival, 1) : "–",
                          peak ? amount(peak->value) : "–", peak ? fixed(peak->time, 1) : "–",
                          amount_or_dash(passed(table, section))});
    if (!flow) continue;
    for (const char* column :
         {" area [m2]", " greatest depth [m]", " mean speed [m/s]", " greatest speed [m/s]"})
      peaks.rows.back().push_back(greatest(flow, section + column));
  }
  peaks.source = flow ? data_line(report, {"series/discharge.csv", "series/sections.csv",
                                           "manifest.toml [quantities]"})
                      : data_line(report, {"series/discharge.csv", "manifest.toml [quantities]"});
  page.table(peaks);
}

void add_series_chart(Report& report, const NumberTable& table, const std::string& suffix,
                      const std::string& title, const std::string& axis,
                      const std::string& source) {
  LineChart chart{title, report.say("axis.time"), axis};
  for (const std::string& name : names_before(table, suffix))
    chart.series.push_back(over_time(table, name + suffix, name));
  if (!chart.series.empty()) report.page.chart(chart, source);
}

}  // namespace

void add_hydrographs(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("section.title"));
  const NumberTable* table = run.series("discharge.csv");
  if (!table) return tell_missing(report, "series/discharge.csv");
  const std::vector<std::string> sections = names_before(*table, discharge);
  if (sections.empty()) return page.text(say("section.none"));
  page.text(say("section.about"));
  const std::string source = data_line(report, {"series/discharge.csv"});
  add_series_chart(report, *table, discharge, say("section.chart"), say("axis.discharge"), source);
  LineChart volumes{say("section.volumes"), say("axis.time"), say("axis.volume")};
  for (const std::string& section : sections)
    volumes.series.push_back(over_time(*table, section + " forward volume [m3]", section));
  page.chart(volumes, source);
  add_peak_table(report, *table, sections);
  if (!run.has("series/sections.csv")) return;
  if (const NumberTable* flow = run.series("sections.csv")) {
    const std::string from = data_line(report, {"series/sections.csv"});
    add_series_chart(report, *flow, " greatest depth [m]", say("section.depths"), say("axis.depth"),
                     from);
    add_series_chart(report, *flow, " mean speed [m/s]", say("section.speeds"), say("axis.speed"),
                     from);
  }
}

void add_gauges(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  if (!run.has("series/gauges.csv")) return;
  const NumberTable* table = run.series("gauges.csv");
  if (!table || names_before(*table, " depth [m]").empty()) return;
  page.section(say("gauge.title"));
  const std::string source = data_line(report, {"series/gauges.csv"});
  add_series_chart(report, *table, " depth [m]", say("gauge.depths"), say("axis.depth"), source);
  add_series_chart(report, *table, " speed [m/s]", say("gauge.speeds"), say("axis.speed"), source);
  LineChart pressures{say("gauge.pressures"), say("axis.time"), say("axis.pressure")};
  ReportTable peaks;
  peaks.caption = say("gauge.peaks");
  peaks.header = {say("column.name"), say("gauge.depth"), say("gauge.speed"),
                  say("gauge.pressure")};
  for (const std::string& name : names_before(*table, " depth [m]")) {
    pressures.series.push_back(over_time(*table, name + " pressure [Pa]", name, 1e-3));
    const auto pressure = peak_of(*table, name + " pressure [Pa]");
    peaks.rows.push_back({name, greatest(table, name + " depth [m]"),
                          greatest(table, name + " speed [m/s]"),
                          pressure ? amount(pressure->value / 1000) : "–"});
  }
  if (!pressures.series.empty()) page.chart(pressures, source);
  peaks.source = source;
  page.table(peaks);
}

/// Of the greatest with its sign: a front that jumps back, as flow leaves the map, has no top
/// speed.
std::optional<double> time_of_greatest(const NumberTable& table, const std::string& column) {
  const std::vector<double>* times = table.find("time [s]");
  const std::vector<double>* values = table.find(column);
  if (!times || !values || values->empty()) return std::nullopt;
  return (*times)[static_cast<std::size_t>(std::ranges::max_element(*values) - values->begin())];
}

void add_front(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("front.title"));
  const NumberTable* table = run.series("front.csv");
  if (!table) return tell_missing(report, "series/front.csv");
  page.text(say("front.about"));
  const std::string source = data_line(report, {"series/front.csv"});
  LineChart position{say("front.position"), say("axis.time"), say("axis.station")};
  position.series = {over_time(*table, "position [m]", say("front.position"))};
  LineChart speed{say("front.speed"), say("axis.time"), say("axis.speed")};
  speed.series = {over_time(*table, "velocity [m/s]", say("front.speed"))};
  page.chart(position, source);
  page.chart(speed, source);
  ReportTable facts;
  facts.header = {"", say("column.value"), say("column.unit")};
  if (const auto runout = run.quantity("front run-out [m]"))
    facts.rows.push_back({say("front.runout"), amount(*runout), "m"});
  if (const auto top = run.quantity("peak front speed [m/s]"))
    facts.rows.push_back({say("front.top_speed"), fixed(*top, 1), "m/s"});
  if (const auto time = time_of_greatest(*table, "velocity [m/s]"))
    facts.rows.push_back({say("front.top_time"), fixed(*time, 1), "s"});
  facts.source = data_line(report, {"series/front.csv", "manifest.toml [quantities]"});
  page.table(facts);
}

}  // namespace sabo
