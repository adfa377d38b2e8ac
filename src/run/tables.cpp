#include "run/tables.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "io/case_file/listing.hpp"
#include "run/amount_text.hpp"

namespace sabo {
namespace {

std::string volume(const std::optional<double>& value) { return value ? amount_text(*value) : "-"; }

PageTable volumes_at(const Case& c, const Scene& scene, const SeriesRow& row,
                     const std::vector<Basin>& basins, std::size_t dam) {
  const VolumeRow& volumes = row.volumes[dam];
  const bool has_dam = dam < scene.check_dams().size();
  PageTable table;
  table.caption = fmt::format("Volumes at {:.1f} s [m3]", row.time);
  if (has_dam) table.caption += ", " + scene.dams[dam].name;
  table.header = {"", "this run"};
  const bool has_inflows = !scene.inflows.empty();
  table.rows = {{has_inflows ? "released and come in" : "released", volume(volumes.released)}};
  if (has_dam) {
    table.rows.push_back({"trapped by the dam", volume(volumes.trapped)});
    table.rows.push_back({"beyond the dam", volume(volumes.beyond)});
  }
  table.rows.push_back({"left the map", volume(volumes.outflow)});
  if (has_dam && basins[dam].capacity() > 0)
    table.rows.push_back(
        {fmt::format("in the basin, which holds {}", amount_text(basins[dam].capacity())),
         volume(row.basins[dam].stored)});
  for (const ReferenceCase& reference : c.references) {
    table.header.push_back(reference.name);
    table.rows[0].push_back(volume(reference.released));
    if (has_dam) {
      table.rows[1].push_back(volume(reference.trapped));
      table.rows[2].push_back(volume(reference.beyond));
    }
    for (std::size_t k = has_dam ? 3 : 1; k < table.rows.size(); ++k) table.rows[k].push_back("-");
  }
  return table;
}

}  // namespace

std::vector<PageTable> volume_tables(const Case& c, const Scene& scene, const SeriesRow& row,
                                     const std::vector<Basin>& basins) {
  std::vector<PageTable> tables;
  for (std::size_t dam = 0; dam < row.volumes.size(); ++dam)
    tables.push_back(volumes_at(c, scene, row, basins, dam));
  return tables;
}

PageTable zone_table(const Case& c, const SeriesRow& row) {
  PageTable table;
  table.caption = fmt::format("Depth in the zones at {:.1f} s", row.time);
  table.header = {"",         "mean where wet [m]", "mean [m]",        "greatest [m]",
                  "wet [m2]", "volume [m3]",        "compare with [m]"};
  for (std::size_t k = 0; k < c.zones.size(); ++k) {
    const ZoneDepth& zone = row.zones[k];
    const ZoneCase& described = c.zones[k];
    table.rows.push_back(
        {described.name, fmt::format("{:.2f}", zone.mean_wet), fmt::format("{:.2f}", zone.mean_all),
         fmt::format("{:.2f}", zone.greatest), amount_text(zone.wet_area), amount_text(zone.volume),
         described.observed ? fmt::format("{:g} ({})", *described.observed, described.source)
                            : "-"});
  }
  return table;
}

PageTable parameter_table(const Case& c) {
  PageTable table;
  table.caption = "Parameters";
  table.header = {"", "value", "unit"};
  for (const ListedTable& listed : list_tables(c)) {
    if (listed.name != "material" && listed.name != "numerics") continue;
    for (const ListedKey& key : listed.keys) {
      if (key.value.empty()) continue;
      table.rows.push_back({fmt::format("{}.{}", listed.name, key.name), key.value, key.unit});
    }
  }
  return table;
}

std::vector<std::string> text_of(const PageTable& table) {
  std::vector<std::vector<std::string>> rows = table.rows;
  rows.insert(rows.begin(), table.header);
  std::vector<std::size_t> widths(table.header.size(), 8);
  for (const std::vector<std::string>& cells : rows)
    for (std::size_t k = 0; k < cells.size(); ++k) widths[k] = std::max(widths[k], cells[k].size());

  std::vector<std::string> lines{table.caption};
  for (const std::vector<std::string>& cells : rows) {
    std::string line = fmt::format("  {:<{}}", cells[0], widths[0]);
    for (std::size_t k = 1; k < cells.size(); ++k)
      line += fmt::format("  {:>{}}", cells[k], widths[k]);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace sabo
