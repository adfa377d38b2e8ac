
#include "report/report_parts.hpp"
#include <fmt/format.h>

namespace sabo {
namespace {

/// The reference volumes of the case that name a key, after the columns of the run.
void add_references(const Report& report, ReportTable& table, bool has_dam) {
  if (!report.run.described()) return;
  for (const ReferenceCase& reference : report.run.described()->references) {
    table.header.push_back(reference.name);
    table.rows[0].push_back(amount_or_dash(reference.released));
    if (has_dam) {
      table.rows[1].push_back(amount_or_dash(reference.trapped));
      table.rows[2].push_back(amount_or_dash(reference.beyond));
    }
    for (std::size_t k = has_dam ? 3 : 1; k < table.rows.size(); ++k) table.rows[k].push_back("–");
  }
}

void add_volume_table(Report& report, const TomlTable& row) {
  const auto& [run, other, say, page, sharpness] = report;
  const auto dam = text_at(row, "dam");
  const double released = number_at(row, "released").value_or(0);
  const double outflow = number_at(row, "outflow").value_or(0);
  ReportTable table;
  table.caption = dam ? say("balance.at", *dam) : say("balance.caption");
  table.header = {say("balance.unit"), say("column.run")};
  table.rows = {{say("balance.released"), amount(released)}};
  double account = outflow;
  if (dam) {
    const double trapped = number_at(row, "trapped").value_or(0);
    const double beyond = number_at(row, "beyond").value_or(0);
    account += trapped + beyond;
    table.rows.push_back({say("balance.trapped"), amount(trapped)});
    table.rows.push_back({say("balance.beyond"), amount(beyond)});
  } else {
    account += run.number("maps", "particle_volume").value_or(released - outflow);
    table.rows.push_back({say("balance.left_on_map"), amount(released - outflow)});
  }
  table.rows.push_back({say("balance.outflow"), amount(outflow)});
  table.rows.push_back({say("balance.difference"), fixed(released - account, 2)});
  const double capacity = number_at(row, "capacity").value_or(0);
  if (const auto stored = number_at(row, "stored"); stored && capacity > 0)
    table.rows.push_back({say("balance.stored", amount(capacity),
                              fixed(number_at(row, "pool_level").value_or(0), 2)),
                          amount(*stored)});
  add_references(report, table, dam.has_value());
  table.source = data_line(report, {"manifest.toml [[volumes]]", "series/volumes.csv"});
  page.table(table);
}

void add_filling(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const NumberTable* table = run.has("series/filling.csv") ? run.series("filling.csv") : nullptr;
  if (!table) return;
  LineChart chart{say("balance.filling"), say("axis.time"), say("axis.filled")};
  for (const std::string& dam : names_before(*table, " filled [1]"))
    chart.series.push_back(over_time(*table, dam + " filled [1]", dam, 100));
  if (!chart.series.empty()) page.chart(chart, data_line(report, {"series/filling.csv"}));
}

}  // namespace

void add_balance(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("balance.title"));
  page.text(say("balance.about"));
  for (const TomlTable& row : run.list("volumes")) add_volume_table(report, row);
  const NumberTable* table = run.series("volumes.csv");
  if (!table) return tell_missing(report, "series/volumes.csv");
  LineChart chart{say("balance.chart"), say("axis.time"), say("axis.volume")};
  for (const std::string& dam : names_before(*table, " trapped [m3]")) {
    chart.series.push_back(
        over_time(*table, dam + " trapped [m3]", say("balance.trapped_by", dam)));
    chart.series.push_back(over_time(*table, dam + " beyond [m3]", say("balance.beyond_of", dam)));
  }
  chart.series.push_back(over_time(*table, "outflow [m3]", say("balance.outflow")));
  page.chart(chart, data_line(report, {"series/volumes.csv"}));
  add_filling(report);
}

void add_zones(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const std::vector<TomlTable> zones = run.list("zones");
  if (zones.empty()) return;
  page.section(say("zone.title"));
  ReportTable table;
  table.caption = say("zone.caption", fixed(run.number("run", "simulated_s").value_or(0), 1));
  table.header = {say("column.zone"),   say("zone.mean_wet"),  say("zone.mean"),
                  say("zone.greatest"), say("zone.area"),      say("zone.volume"),
                  say("zone.observed"), say("zone.difference")};
  for (const TomlTable& zone : zones) {
    const std::string name = text_at(zone, "zone").value_or("");
    const auto mean = number_at(zone, "mean_wet");
    std::string observed = "–", difference = "–";
    if (run.described())
      for (const ZoneCase& described : run.described()->zones)
        if (described.name == name && described.observed) {
          observed = fmt::format("{:g} ({})", *described.observed, described.source);
          if (mean) difference = fixed(*mean - *described.observed, 2);
        }
    table.rows.push_back({name, mean ? fixed(*mean, 2) : "–",
                          fixed(number_at(zone, "mean_all").value_or(0), 2),
                          fixed(number_at(zone, "greatest").value_or(0), 2),
                          amount_or_dash(number_at(zone, "wet_area")),
                          amount_or_dash(number_at(zone, "volume")), observed, difference});
  }
  table.source = data_line(report, {"manifest.toml [[zones]]", "series/zones.csv"});
  page.table(table);
}

}  // namespace sabo
