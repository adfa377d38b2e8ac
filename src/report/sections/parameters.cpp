#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "report/report_parts.hpp"

#include "case/material_presets.hpp"
#include "io/case_file/listing.hpp"
#include "io/output/map_line.hpp"

namespace sabo {
namespace {

/// Keys that the method of the case does not use start with the name of the other one.
bool is_used(const ListedKey& key, Method method) {
  if (key.value.empty()) return false;
  return !key.help.starts_with(method == Method::fast ? "paper:" : "fast:");
}

/// Of the method the choices that decide the result; those that only tune it are in the case file.
constexpr std::array<std::string_view, 12> deciding_keys{
    "spacing",           "method",         "h_over_dp",        "sound_speed_factor",
    "density_diffusion", "diffusion_form", "viscous_operator", "boundary_stress",
    "boundary_pressure", "wall",           "sleep_speed",      "gravity"};

/// Of the wall laws those keys that the chosen one reads.
bool is_of_wall(const ListedKey& key, WallLaw wall) {
  const bool has_friction = wall == WallLaw::coulomb || wall == WallLaw::voellmy;
  if (key.name == "wall_turbulence") return wall == WallLaw::voellmy;
  return has_friction && key.name.starts_with("wall_");
}

bool is_shown(const std::string& table, const ListedKey& key, const Case& c) {
  if (table != "numerics") return true;
  if (c.numerics.method == Method::fast && is_of_wall(key, c.numerics.wall)) return true;
  return std::ranges::find(deciding_keys, key.name) != deciding_keys.end();
}

/// A value of TOML as text: without the quotes.
std::string plain(const std::string& value) {
  const bool is_quoted = value.size() >= 2 && value.front() == '"' && value.back() == '"';
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

ReportTable key_table(const Report& report, const Case& c, const std::string& name) {
  ReportTable table;
  table.header = {report.say("parameter.what"), report.say("parameter.key"),
                  report.say("column.value"), report.say("column.unit")};
  for (const ListedTable& listed : list_tables(c)) {
    if (listed.name != name || !listed.is_given) continue;
    for (const ListedKey& key : listed.keys)
      if (is_used(key, c.numerics.method) && is_shown(name, key, c))
        table.rows.push_back({report.say.get("key." + key.name, key.help), key.name,
                              plain(key.value), shown_unit(key.unit)});
  }
  table.source = data_line(report, {"case.toml"});
  return table;
}

void tell_material_source(Report& report, const Case& c) {
  const std::string law(name_of(c.material.law));
  report.page.text(report.say("parameter.law", law, source_of_law(law)));
  const MaterialPreset* preset = find_preset(c.material.preset.name);
  if (!preset) return report.page.text(report.say("parameter.no_preset"));
  report.page.text(report.say("parameter.preset", preset->name, preset->summary, preset->source));
  report.page.text(report.say("parameter.caution", preset->caution));
}

}  // namespace

void add_parameters(Report& report) {
  report.page.section(report.say("parameter.title"));
  if (!report.run.described()) return tell_missing(report, "case.toml");
  const Case& c = *report.run.described();
  ReportTable material = key_table(report, c, "material");
  material.caption = report.say("parameter.material");
  report.page.table(material);
  tell_material_source(report, c);
  ReportTable method = key_table(report, c, "numerics");
  method.caption = report.say("parameter.method");
  report.page.table(method);
  report.page.text(report.say("parameter.method_source"));
}

void add_structures(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("structure.title"));
  if (!run.described()) return tell_missing(report, "case.toml");
  ReportTable lines;
  lines.caption = say("structure.lines");
  lines.header = {say("column.name"), say("structure.length"), say("structure.crest")};
  for (const MapLine& line : run.plan()) {
    if (line.kind != MapLine::Kind::dam || line.label.empty() || !line.line.has_z) continue;
    const auto [low, high] = std::ranges::minmax(line.line.vertices, {}, &Vec3d::z);
    const std::string crest =
        high.z - low.z < 0.005 ? fixed(high.z, 2) : fixed(low.z, 2) + " – " + fixed(high.z, 2);
    lines.rows.push_back({line.label, fixed(length(line.line), 1), crest});
  }
  lines.source = data_line(report, {"maps/plan.geojson"});
  page.table(lines);

  ReportTable keys;
  keys.caption = say("structure.keys");
  keys.header = {say("parameter.key"), say("structure.what"), say("column.value"),
                 say("column.unit")};
  for (const ListedTable& listed : list_tables(*run.described())) {
    const bool is_solid = listed.name.starts_with("structure") || listed.name.starts_with("body");
    if (!is_solid || !listed.is_given) continue;
    for (const ListedKey& key : listed.keys)
      if (!plain(key.value).empty())
        keys.rows.push_back({listed.name + "." + key.name, key.help, shown_file(plain(key.value)),
                             shown_unit(key.unit)});
  }
  keys.is_of_words = true;
  keys.source = data_line(report, {"case.toml"});
  if (keys.rows.empty()) page.text(say("structure.none"));
  page.table(keys);
}

}  // namespace sabo
