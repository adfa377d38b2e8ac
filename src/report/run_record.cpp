#include "report/run_record.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "io/case_file/read_case.hpp"
#include "io/case_file/text_check.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"
#include "io/output/plan_file.hpp"
#include "io/output/read_file.hpp"
#include "run/read_manifest.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

}  // namespace

RunRecord::RunRecord(fs::path folder)
    : folder_(std::move(folder)), manifest_(read_manifest(folder_)) {
  read_case_file();
}

void RunRecord::read_case_file() {
  const auto content = read_file(folder_ / "case.toml", largest_written_case);
  Faults faults;
  const auto text =
      content ? parse_toml(*content, "case.toml", faults, largest_written_case) : std::nullopt;
  if (!text) {
    missing_.insert("case.toml");
    return;
  }
  case_text_ = *text;
  // Faults are of use here only where they leave nothing.
  Case c = read_former_case(*content, folder_, faults);
  if (c.numerics.spacing > 0) case_ = std::move(c);
}

std::optional<double> RunRecord::number(std::string_view table, std::string_view key) const {
  const auto value = number_at(table_at(manifest_, table), key);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string RunRecord::text(std::string_view table, std::string_view key) const {
  return text_at(table_at(manifest_, table), key).value_or("");
}

bool RunRecord::is_true(std::string_view table, std::string_view key) const {
  return is_true_at(table_at(manifest_, table), key);
}

TomlTable RunRecord::table(std::string_view name) const { return table_at(manifest_, name); }

std::vector<TomlTable> RunRecord::list(std::string_view name) const {
  std::vector<TomlTable> tables;
  for (const TomlTable* table : tables_at(manifest_, name)) tables.push_back(*table);
  return tables;
}

std::string RunRecord::written(std::string_view table, std::string_view key) const {
  return text_at(table.empty() ? case_text_ : table_at(case_text_, table), key).value_or("");
}

const NumberTable* RunRecord::series(const std::string& name) {
  const auto [place, is_new] = series_.try_emplace(name);
  if (is_new) {
    try {
      place->second = read_number_table(folder_ / "series" / name);
    } catch (const CaseError&) {  // as if it were not there
    }
    if (!place->second) missing_.insert("series/" + name);
  }
  return place->second ? &*place->second : nullptr;
}

const MapRecord* RunRecord::map(const std::string& name) {
  const auto [place, is_new] = maps_.try_emplace(name);
  if (is_new) {
    try {
      const RasterFile file(folder_ / "maps" / (name + ".tif"), "maps");
      place->second = MapRecord{file.read(), file.unit(), wkt_of(file.crs())};
    } catch (const CaseError&) {
      missing_.insert("maps/" + name + ".tif");
    }
  }
  return place->second ? &*place->second : nullptr;
}

const std::vector<MapLine>& RunRecord::plan() {
  if (!plan_) {
    try {
      plan_ = read_plan(folder_ / "maps" / "plan.geojson");
    } catch (const CaseError&) {
      missing_.insert("maps/plan.geojson");
      plan_.emplace();
    }
  }
  return *plan_;
}

std::vector<std::string> RunRecord::map_names() const {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / "maps", error))
    if (entry.path().extension() == ".tif") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

bool RunRecord::has(const std::string& file) const {
  std::error_code error;
  return fs::exists(folder_ / file, error);
}

}  // namespace sabo
