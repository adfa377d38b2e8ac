#include "report/run_record.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "io/case_file/read_case.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"
#include "io/output/plan_file.hpp"
#include "io/output/read_file.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_text = 1'000'000;  // bytes of a TOML file

const TomlTable* table_in(const TomlTable& tables, std::string_view name) {
  const TomlNode* node = find(tables, name);
  return node ? std::get_if<TomlTable>(&node->value) : nullptr;
}

TomlTable read_manifest(const fs::path& folder) {
  const fs::path file = folder / "manifest.toml";
  const auto content = read_file(file, max_text);
  if (!content)
    throw CaseError(folder.string(), "is not the folder of a run: it has no readable manifest.toml",
                    "give a folder that `sabo run` has written");
  Faults faults;
  const auto manifest = parse_toml(*content, file.string(), faults);
  faults.throw_if_any();
  if (!table_in(*manifest, "run"))
    throw CaseError(file.string(), "has no table [run]",
                    "give a folder that `sabo run` has written");
  return *manifest;
}

}  // namespace

RunRecord::RunRecord(fs::path folder)
    : folder_(std::move(folder)), manifest_(read_manifest(folder_)) {
  read_case_file();
}

void RunRecord::read_case_file() {
  const auto content = read_file(folder_ / "case.toml", max_text);
  Faults faults;
  const auto text = content ? parse_toml(*content, "case.toml", faults) : std::nullopt;
  if (!text) {
    missing_.insert("case.toml");
    return;
  }
  case_text_ = *text;
  // Faults are of use here only where they leave nothing: inputs may have moved since the run.
  Case c = read_case_text(*content, folder_, faults);
  if (c.numerics.spacing > 0) case_ = std::move(c);
}

std::optional<double> RunRecord::number(std::string_view table, std::string_view key) const {
  const TomlTable* found = table_in(manifest_, table);
  const auto value = found ? number_at(*found, key) : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string RunRecord::text(std::string_view table, std::string_view key) const {
  const TomlTable* found = table_in(manifest_, table);
  return found ? text_at(*found, key).value_or("") : "";
}

bool RunRecord::is_true(std::string_view table, std::string_view key) const {
  const TomlTable* found = table_in(manifest_, table);
  const TomlNode* node = found ? find(*found, key) : nullptr;
  const bool* value = node ? std::get_if<bool>(&node->value) : nullptr;
  return value && *value;
}

TomlTable RunRecord::table(std::string_view name) const {
  const TomlTable* found = table_in(manifest_, name);
  return found ? *found : TomlTable{};
}

std::vector<TomlTable> RunRecord::list(std::string_view name) const {
  std::vector<TomlTable> tables;
  const TomlNode* node = find(manifest_, name);
  if (const auto* items = node ? std::get_if<TomlArray>(&node->value) : nullptr)
    for (const TomlNode& item : *items)
      if (const auto* table = std::get_if<TomlTable>(&item.value)) tables.push_back(*table);
  return tables;
}

std::string RunRecord::written(std::string_view table, std::string_view key) const {
  const TomlTable* found = table.empty() ? &case_text_ : table_in(case_text_, table);
  return found ? text_at(*found, key).value_or("") : "";
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
