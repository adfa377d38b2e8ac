#include "run/batch_record.hpp"

#include <algorithm>
#include <string_view>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/case_file/read_case.hpp"
#include "io/case_file/toml_tree.hpp"
#include "io/case_file/write_case.hpp"
#include "io/output/read_file.hpp"
#include "run/manifest.hpp"
#include "run/read_manifest.hpp"

namespace sabo {
namespace {

std::vector<std::pair<std::string, double>> numbers_of(const TomlTable& table) {
  std::vector<std::pair<std::string, double>> list;
  for (const TomlEntry& entry : table)
    if (const auto number = number_at(table, entry.key)) list.emplace_back(entry.key, *number);
  return list;
}

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
  const auto text = read_file(folder / "manifest.toml", largest_manifest);
  if (!text) return std::nullopt;
  Faults faults;
  const auto manifest = parse_toml(*text, "manifest.toml", faults, largest_manifest);
  if (!manifest) return std::nullopt;
  const TomlTable& run = table_at(*manifest, "run");
  if (text_at(run, "end") != "finished" || text_at(run, "version") != build_version)
    return std::nullopt;
  if (!text->ends_with(input_checksums(c)) || !is_case_of(folder, c)) return std::nullopt;

  const auto number = [&](std::string_view table, std::string_view key) {
    return number_at(table_at(*manifest, table), key).value_or(0);
  };
  BatchRecord record;
  record.spacing = c.numerics.spacing;
  record.simulated = number("run", "simulated_s");
  record.wall = number("run", "wall_s");
  record.particles = number("run", "particles");
  record.median_layers = number("resolution", "median_layers");
  record.at_rest = is_true_at(table_at(*manifest, "motion"), "at_rest");
  record.energy_imbalance = number("energy", "imbalance");
  if (const double released = number("energy", "released_J"); released > 0)
    for (const char* key : {"artificial_viscosity_J", "density_diffusion_J", "density_hold_J",
                            "shifting_J", "sound_speed_J", "walls_J"})
      record.energy_to_scheme += number("energy", key) / released;
  record.quantities = numbers_of(table_at(*manifest, "quantities"));
  return record;
}

}  // namespace sabo
