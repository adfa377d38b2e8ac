#include "run/volume_table.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace sabo {
namespace {

std::string volume(const std::optional<double>& value) {
  return value ? fmt::format("{:.0f}", *value) : "-";
}

PageTable table_at(const Case& c, const Scene& scene, const SeriesRow& row, std::size_t dam) {
  const VolumeRow& volumes = row.volumes[dam];
  const bool has_dam = dam < scene.dams.size();
  PageTable table;
  table.caption = fmt::format("Volumes at {:.1f} s [m3]", row.time);
  if (has_dam) table.caption += ", " + scene.dams[dam].name;
  table.header = {"", "this run"};
  table.rows = {{"released", volume(volumes.released)}};
  if (has_dam) {
    table.rows.push_back({"trapped by the dam", volume(volumes.trapped)});
    table.rows.push_back({"beyond the dam", volume(volumes.beyond)});
  }
  table.rows.push_back({"left the map", volume(volumes.outflow)});
  for (const ReferenceCase& reference : c.references) {
    table.header.push_back(reference.name);
    table.rows[0].push_back(volume(reference.released));
    if (has_dam) {
      table.rows[1].push_back(volume(reference.trapped));
      table.rows[2].push_back(volume(reference.beyond));
    }
    table.rows.back().push_back("-");
  }
  return table;
}

}  // namespace

std::vector<PageTable> volume_tables(const Case& c, const Scene& scene, const SeriesRow& row) {
  std::vector<PageTable> tables;
  for (std::size_t dam = 0; dam < row.volumes.size(); ++dam)
    tables.push_back(table_at(c, scene, row, dam));
  return tables;
}

std::vector<std::string> volume_table_text(const Case& c, const Scene& scene,
                                           const SeriesRow& row) {
  std::vector<std::string> lines;
  for (const PageTable& table : volume_tables(c, scene, row)) {
    lines.push_back(table.caption);
    std::vector<std::vector<std::string>> rows = table.rows;
    rows.insert(rows.begin(), table.header);
    for (const std::vector<std::string>& cells : rows) {
      std::string line = fmt::format("  {:<20}", cells[0]);
      for (std::size_t k = 1; k < cells.size(); ++k)
        line +=
            fmt::format("  {:>{}}", cells[k], std::max<std::size_t>(12, table.header[k].size()));
      lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace sabo
