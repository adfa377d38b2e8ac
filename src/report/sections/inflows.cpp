#include "report/report_parts.hpp"

namespace sabo {

void add_inflows(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const std::vector<TomlTable> inflows = run.list("inflow");
  if (inflows.empty()) return;
  page.text(say("inflow.about"));
  ReportTable table;
  table.caption = say("inflow.caption", fixed(run.number("run", "simulated_s").value_or(0), 1));
  table.header = {say("inflow.name"),      say("inflow.hydrograph"), say("inflow.entered"),
                  say("inflow.discharge"), say("inflow.time"),       say("inflow.depth"),
                  say("inflow.speed")};
  for (const TomlTable& inflow : inflows) {
    table.rows.push_back({text_at(inflow, "inflow").value_or("")});
    for (const char* key :
         {"hydrograph", "entered", "peak_discharge", "peak_time", "peak_depth", "peak_speed"})
      table.rows.back().push_back(amount_or_dash(number_at(inflow, key)));
  }
  table.source = data_line(report, {"manifest.toml [[inflow]]", "series/volumes.csv"});
  page.table(table);
  const NumberTable* series = run.series("volumes.csv");
  if (!series) return tell_missing(report, "series/volumes.csv");
  LineChart chart{say("inflow.chart"), say("axis.time"), say("axis.volume")};
  for (const std::string& name : names_before(*series, " hydrograph [m3]")) {
    chart.series.push_back(
        over_time(*series, name + " hydrograph [m3]", say("inflow.hydrograph_of", name)));
    chart.series.push_back(
        over_time(*series, name + " entered [m3]", say("inflow.entered_by", name)));
  }
  if (!chart.series.empty()) page.chart(chart, data_line(report, {"series/volumes.csv"}));
}

}  // namespace sabo
