#include <algorithm>
#include <cmath>

#include "report/report_maps.hpp"
#include <fmt/format.h>

#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/geographic.hpp"

namespace sabo {
namespace {

std::string place_text(const Report& report, const MapRecord& ground, const MapView& view) {
  const auto place =
      geographic(ground.crs, (view.west + view.east) / 2, (view.south + view.north) / 2);
  if (!place) return report.say("site.unplaced");
  return fmt::format("{:.5f}° {}, {:.5f}° {}", std::abs(place->latitude),
                     place->latitude < 0 ? "S" : "N", std::abs(place->longitude),
                     place->longitude < 0 ? "W" : "E");
}

std::string crs_text(const Report& report, const std::string& wkt) {
  const GdalErrors errors;
  const OGRSpatialReference crs = crs_of(wkt);
  return is_unknown(crs) ? report.say("site.no_crs") : name_of(crs);
}

std::string elevations_text(const Raster& ground) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double z : ground.values) {
    if (std::isnan(z)) continue;
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return low <= high ? fmt::format("{} – {} m", fixed(low, 1), fixed(high, 1)) : "–";
}

/// The checksum of a file that the case names; "–" where the manifest does not have it.
std::string checksum_text(const RunRecord& run, const std::string& file) {
  for (const TomlEntry& input : run.table("inputs"))
    if (input.key == file)
      if (const auto* sum = std::get_if<std::string>(&input.node.value)) return *sum;
  return "–";
}

std::string dem_text(const Report& report) {
  const std::string dem = report.run.written("terrain", "dem");
  if (dem.empty()) return report.say("site.plane");
  return fmt::format("{} (CRC-32 {})", shown_file(dem), checksum_text(report.run, dem));
}

void tell_edits(Report& report) {
  ReportTable table;
  table.caption = report.say("site.edits");
  table.header = {report.say("column.name"), report.say("site.edit_kind"),
                  report.say("site.cells"),  report.say("site.cut"),
                  report.say("site.fill"),   report.say("site.change")};
  for (const TomlTable& edit : report.run.list("edit"))
    table.rows.push_back({text_at(edit, "edit").value_or(""), text_at(edit, "kind").value_or(""),
                          amount_or_dash(number_at(edit, "cells")),
                          amount_or_dash(number_at(edit, "cut")),
                          amount_or_dash(number_at(edit, "fill")),
                          amount_or_dash(number_at(edit, "greatest_change"))});
  const auto& described = report.run.described();
  if (table.rows.empty() && described && !described->terrain.edits.empty())
    return tell_missing(report, "manifest.toml [[edit]]");
  if (table.rows.empty()) return report.page.text(report.say("site.no_edits"));
  table.source = data_line(report, {"manifest.toml"});
  report.page.table(table);
}

}  // namespace

void add_site(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("site.title"));
  const MapRecord* ground = run.map("ground");
  ReportTable table;
  table.is_of_words = true;
  if (ground) {
    const Grid& grid = ground->raster.grid;
    table.rows = {
        {say("site.place"), place_text(report, *ground, view_of_flow(run))},
        {say("site.crs"), crs_text(report, ground->crs)},
        {say("site.extent"), fmt::format("E {:.1f} – {:.1f} m, N {:.1f} – {:.1f} m", grid.west,
                                         grid.east(), grid.south(), grid.north)},
        {say("site.cell"),
         fmt::format("{:g} × {:g} m, {} × {}", grid.dx, grid.dy, grid.columns, grid.rows)},
        {say("site.elevation"), elevations_text(ground->raster)}};
  }
  table.rows.push_back({say("site.dem"), dem_text(report)});
  const TomlTable terrain = run.table("terrain");
  if (const TomlNode* notes = find(terrain, "notes"))
    if (const auto* list = std::get_if<TomlArray>(&notes->value))
      for (const TomlNode& note : *list)
        if (const auto* text = std::get_if<std::string>(&note.value))
          table.rows.push_back({say("site.done"), *text});
  if (number_at(terrain, "cells_filled").value_or(0) > 0)
    table.rows.push_back(
        {say("site.done"), say("site.holes", amount(*number_at(terrain, "cells_filled")))});
  table.source = data_line(report, {"maps/ground.tif", "manifest.toml", "case.toml"});
  page.table(table);
  tell_edits(report);
  add_location_map(report);
  add_map_key(report);
}

void add_release(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  page.section(say("release.title"));
  const bool has_mass = run.number("release", "volume") != 0.0;
  ReportTable table;
  table.header = {"", say("column.value"), say("column.unit")};
  for (const auto& [label, key, unit] : {std::array{"release.volume", "volume", "m³"},
                                         {"release.area", "area", "m²"},
                                         {"release.mean", "mean_depth", "m"},
                                         {"release.greatest", "greatest_depth", "m"}})
    if (const auto value = run.number("release", key); value && has_mass)
      table.rows.push_back({say(label), amount(*value), unit});
  if (const auto particles = run.number("run", "particles"))
    table.rows.push_back({say("release.particles"), amount(*particles), ""});
  table.source = data_line(report, {"manifest.toml", "maps/rel.tif"});
  if (table.rows.empty()) tell_missing(report, "manifest.toml [release]");
  page.table(table);
  for (const char* key : {"polygon", "thickness_raster", "points", "dem_before", "dem_after"}) {
    const std::string file = run.written("release", key);
    if (!file.empty())
      page.text(say("release.file", key, shown_file(file), checksum_text(run, file)));
  }
  add_inflows(report);
}

}  // namespace sabo
