#include <algorithm>
#include <array>

#include "report/report_maps.hpp"
#include <fmt/format.h>

#include "run/pictures.hpp"

namespace sabo {
namespace {

/// The least and greatest of a column.
std::optional<std::pair<double, double>> range_of(const NumberTable& table, const char* lowest,
                                                  const char* highest) {
  const std::vector<double>* low = table.find(lowest);
  const std::vector<double>* high = table.find(highest);
  if (!low || !high || low->size() < 2) return std::nullopt;
  // The first row is of before the first step.
  return std::pair{*std::min_element(low->begin() + 1, low->end()),
                   *std::max_element(high->begin() + 1, high->end())};
}

void add_energy_table(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const auto released = run.number("energy", "released_J");
  if (!released) return tell_missing(report, "manifest.toml [energy]");
  ReportTable table;
  table.caption = say("ledger.energy");
  table.header = {"", say("column.value") + " [MJ]", say("ledger.share")};
  const auto add = [&](const std::string& label, double joule) {
    table.rows.push_back(
        {label, amount(joule / 1e6), *released != 0 ? percent(joule / *released, 2) : "–"});
  };
  add(say("ledger.released"), *released);
  for (const auto& [key, label] : {std::array{"dissipated_J", "ledger.dissipated"},
                                   {"kinetic_J", "ledger.kinetic"},
                                   {"artificial_viscosity_J", "ledger.artificial_viscosity"},
                                   {"density_diffusion_J", "ledger.density_diffusion"},
                                   {"density_hold_J", "ledger.density_hold"},
                                   {"shifting_J", "ledger.shifting"},
                                   {"sound_speed_J", "ledger.sound_speed"},
                                   {"walls_J", "ledger.walls"},
                                   {"carried_off_J", "ledger.carried_off"}})
    if (const auto value = report.run.number("energy", key)) add(report.say(label), *value);
  if (const auto share = run.number("energy", "imbalance"))
    add(say("ledger.unaccounted"), *share * *released);
  table.source = data_line(report, {"manifest.toml [energy]", "series/energy.csv"});
  page.table(table);
}

void add_energy_chart(Report& report) {
  const NumberTable* table = report.run.series("energy.csv");
  if (!table) return tell_missing(report, "series/energy.csv");
  LineChart chart{report.say("ledger.chart"), report.say("axis.time"), report.say("axis.energy")};
  for (const auto& [column, label] : {std::array{"kinetic [J]", "ledger.kinetic"},
                                      {"dissipated [J]", "ledger.dissipated"},
                                      {"numerical [J]", "ledger.numerical"},
                                      {"left the map [J]", "ledger.carried_off"}})
    chart.series.push_back(over_time(*table, column, report.say(label), 1e-6));
  report.page.chart(chart, data_line(report, {"series/energy.csv"}));
}

void add_health_table(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  ReportTable table;
  table.caption = say("ledger.health");
  table.header = {"", say("column.value")};
  if (const NumberTable* solver = run.series("solver.csv"))
    if (const auto range = range_of(*solver, "lowest density ratio", "highest density ratio"))
      table.rows.push_back(
          {say("ledger.density"), fixed(range->first, 4) + " – " + fixed(range->second, 4)});
  for (const TomlTable& row : run.list("volumes"))
    if (const auto count = number_at(row, "put_back")) {
      table.rows.push_back({say("ledger.put_back"), amount(*count)});
      break;
    }
  const auto raster = run.number("maps", "raster_volume"),
             mass = run.number("maps", "particle_volume");
  if (raster && mass) {
    table.rows.push_back({say("ledger.raster_volume"), amount(*raster)});
    table.rows.push_back({say("ledger.particle_volume"), amount(*mass)});
    table.rows.push_back(
        {say("ledger.volume_error"), *mass > 0 ? percent(*raster / *mass - 1, 4) : "–"});
  }
  if (const auto speed = run.number("run", "top_speed"))
    table.rows.push_back({say("ledger.top_speed"), fixed(*speed, 1)});
  if (const auto speed = run.number("run", "sound_speed"))
    table.rows.push_back({say("ledger.sound"), fixed(*speed, 1)});
  table.source = data_line(report, {"series/solver.csv", "manifest.toml", "maps/dep.tif"});
  page.table(table);
}

/// The classes of the map with labels in the language of the report.
std::vector<ColourStep> labelled_steps(const Report& report) {
  std::vector<ColourStep> steps = resolution_steps();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const std::string from = k == 0 ? "" : fmt::format("{:g}", steps[k - 1].end);
    const std::string to = fmt::format("{:g}", steps[k].end);
    const bool is_last = k + 1 == steps.size();
    steps[k].label = k == 0    ? report.say("resolution.step_under", to)
                     : is_last ? report.say("resolution.step_over", from)
                               : from + " – " + to;
  }
  return steps;
}

}  // namespace

void add_resolution(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("resolution.title"));
  const auto median = run.number("resolution", "median_layers");
  if (!median) return tell_missing(report, "manifest.toml [resolution]");
  tell_resolution(report, *median, true);
  const double thin = run.number("resolution", "thin_share").value_or(0);
  const double barely = run.number("resolution", "barely_share").value_or(0);
  ReportTable table;
  table.caption = say("resolution.table");
  table.header = {say("resolution.class"), say("resolution.share")};
  table.rows = {{say("resolution.under"), percent(thin, 1)},
                {say("resolution.between"), percent(barely, 1)},
                {say("resolution.over"), percent(1 - thin - barely, 1)}};
  table.source = data_line(report, {"manifest.toml [resolution]", "maps/res.tif"});
  page.table(table);
  MapStyle style{say("resolution.map"), say("resolution.quantity")};
  style.steps = labelled_steps(report);
  add_map(report, "res", style);
}

void add_ledger(Report& report) {
  report.page.section(report.say("ledger.title"));
  report.page.text(report.say("ledger.about"));
  add_energy_table(report);
  add_energy_chart(report);
  add_health_table(report);
}

void add_limits(Report& report) {
  report.page.section(report.say("limits.title"));
  report.page.heading(report.say("limits.not_modelled"));
  report.page.list(report.say.list("not_modelled"));
  report.page.heading(report.say("limits.validity"));
  report.page.list(report.say.list("validity"));
}

void add_inputs(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("input.title"));
  ReportTable inputs;
  inputs.is_of_words = true;
  inputs.caption = say("input.files");
  inputs.header = {say("input.file"), "CRC-32"};
  for (const TomlEntry& input : run.table("inputs"))
    if (const auto* sum = std::get_if<std::string>(&input.node.value))
      inputs.rows.push_back({shown_file(input.key), *sum});
  inputs.source = data_line(report, {"manifest.toml [inputs]"});
  page.table(inputs);
  ReportTable facts;
  facts.is_of_words = true;
  facts.caption = say("input.run");
  const auto add = [&facts](const std::string& label, const std::string& value) {
    if (!value.empty()) facts.rows.push_back({label, value});
  };
  const auto add_number = [&](const std::string& label, const char* key, const char* unit) {
    if (const auto value = report.run.number("run", key)) add(label, amount(*value) + unit);
  };
  add(say("input.version"), run.text("run", "version"));
  add(say("input.compiler"), run.text("run", "compiler"));
  add(say("input.machine"), run.text("run", "machine"));
  add(say("input.started"), run.text("run", "started"));
  add_number(say("input.wall"), "wall_s", " s");
  add_number(say("input.simulated"), "simulated_s", " s");
  add_number(say("input.steps"), "steps", "");
  add_number(say("input.particles"), "particles", "");
  add_number(say("input.boundary"), "boundary_particles", "");
  facts.source = data_line(report, {"manifest.toml [run]"});
  page.table(facts);
}

void add_files(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("file.title"));
  page.text(say("file.about"));
  ReportTable table;
  table.is_of_words = true;
  table.header = {say("input.file"), say("file.what")};
  for (const auto& [file, key] : {std::array{"manifest.toml", "file.manifest"},
                                  {"case.toml", "file.case"},
                                  {"maps/*.tif", "file.maps"},
                                  {"maps/plan.geojson", "file.plan"},
                                  {"series/front.csv", "file.front"},
                                  {"series/discharge.csv", "file.discharge"},
                                  {"series/volumes.csv", "file.volumes"},
                                  {"series/filling.csv", "file.filling"},
                                  {"series/sections.csv", "file.sections"},
                                  {"series/gauges.csv", "file.gauges"},
                                  {"series/zones.csv", "file.zones"},
                                  {"series/loads.csv", "file.loads"},
                                  {"series/energy.csv", "file.energy"},
                                  {"series/solver.csv", "file.solver"},
                                  {"frames/flow.pvd", "file.frames"}}) {
    const std::string name = file;
    if (name.find('*') != name.npos ? !run.map_names().empty() : run.has(name))
      table.rows.push_back({name, say(key)});
  }
  page.table(table);
  if (run.missing().empty()) return;
  std::string missing;
  for (const std::string& file : run.missing()) missing += (missing.empty() ? "" : ", ") + file;
  page.notice(Tone::caution, say("file.missing"), missing);
}

}  // namespace sabo
