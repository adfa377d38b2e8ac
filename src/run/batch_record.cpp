#include "run/batch_record.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/case_file/read_case.hpp"
#include "io/case_file/toml_tree.hpp"
#include "io/case_file/write_case.hpp"
#include "io/output/read_file.hpp"
#include "run/manifest.hpp"

namespace sabo {
namespace {

constexpr std::size_t max_manifest = 1'000'000;  // bytes

/// One table of a manifest; without it everything in it is missing.
class ManifestTable {
 public:
  ManifestTable(const TomlTable& manifest, std::string_view name) {
    if (const TomlNode* node = find(manifest, name)) table_ = std::get_if<TomlTable>(&node->value);
  }

  double number(std::string_view key) const {
    return table_ ? number_at(*table_, key).value_or(0) : 0;
  }
  bool says(std::string_view key, const std::string& text) const {
    return table_ && text_at(*table_, key) == text;
  }
  bool is_true(std::string_view key) const {
    const TomlNode* found = table_ ? find(*table_, key) : nullptr;
    const bool* value = found ? std::get_if<bool>(&found->value) : nullptr;
    return value && *value;
  }
  std::vector<std::pair<std::string, double>> numbers() const {
    std::vector<std::pair<std::string, double>> list;
    if (!table_) return list;
    for (const TomlEntry& entry : *table_)
      if (const auto number = number_at(*table_, entry.key)) list.emplace_back(entry.key, *number);
    return list;
  }

 private:
  const TomlTable* table_ = nullptr;
};

bool is_case_of(const std::filesystem::path& folder, const Case& c) {
  Faults faults;
  Case written = read_case(folder, faults);
  if (!faults.empty()) return false;
  written.numerics.threads = c.numerics.threads;  // results do not depend on it
  return write_case(written) == write_case(c);
}

}  // namespace

std::optional<double> BatchRecord::quantity(std::string_view label) const {
  const auto found = std::ranges::find(quantities, label, &std::pair<std::string, double>::first);
  return found == quantities.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> quantity_labels(const std::vector<BatchRecord>& records) {
  std::vector<std::string> labels;
  for (const BatchRecord& record : records)
    for (const auto& [label, value] : record.quantities)
      if (std::ranges::find(labels, label) == labels.end()) labels.push_back(label);
  return labels;
}

std::optional<BatchRecord> finished_record(const std::filesystem::path& folder, const Case& c) {
  const auto text = read_file(folder / "manifest.toml", max_manifest);
  if (!text) return std::nullopt;
  Faults faults;
  const auto manifest = parse_toml(*text, "manifest.toml", faults);
  if (!manifest) return std::nullopt;
  const ManifestTable run(*manifest, "run");
  if (!run.says("end", "finished") || !run.says("version", build_version)) return std::nullopt;
  if (!text->ends_with(input_checksums(c)) || !is_case_of(folder, c)) return std::nullopt;

  BatchRecord record;
  record.spacing = c.numerics.spacing;
  record.simulated = run.number("simulated_s");
  record.wall = run.number("wall_s");
  record.particles = run.number("particles");
  record.median_layers = ManifestTable(*manifest, "resolution").number("median_layers");
  record.at_rest = ManifestTable(*manifest, "motion").is_true("at_rest");
  record.energy_imbalance = ManifestTable(*manifest, "energy").number("imbalance");
  record.quantities = ManifestTable(*manifest, "quantities").numbers();
  return record;
}

}  // namespace sabo
