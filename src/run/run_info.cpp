#include "run/run_info.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include "run/read_manifest.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

/// Units of the manifest's keys.
const std::map<std::string_view, std::string_view> units{{"top_speed", "m/s"},
                                                         {"sound_speed", "m/s"},
                                                         {"released", "m3"},
                                                         {"outflow", "m3"},
                                                         {"trapped", "m3"},
                                                         {"beyond", "m3"},
                                                         {"raster_volume", "m3"},
                                                         {"particle_volume", "m3"},
                                                         {"wet_area", "m2"},
                                                         {"mean_wet", "m"},
                                                         {"area", "m2"},
                                                         {"mean_depth", "m"},
                                                         {"greatest_depth", "m"},
                                                         {"cut", "m3"},
                                                         {"fill", "m3"},
                                                         {"greatest_change", "m"},
                                                         {"mean_all", "m"},
                                                         {"greatest", "m"},
                                                         {"volume", "m3"},
                                                         {"moving_volume", "m3"},
                                                         {"creep", "spacings/min"},
                                                         {"stored", "m3"},
                                                         {"capacity", "m3"},
                                                         {"pool_level", "m"},
                                                         {"entered", "m3"},
                                                         {"hydrograph", "m3"},
                                                         {"whole_hydrograph", "m3"},
                                                         {"peak_discharge", "m3/s"},
                                                         {"peak_time", "s"},
                                                         {"row_time", "s"},
                                                         {"peak_depth", "m"},
                                                         {"peak_speed", "m/s"},
                                                         {"peak_level", "m"},
                                                         {"peak_force", "N"},
                                                         {"filter", "s"},
                                                         {"hydrostatic", "N"},
                                                         {"dynamic", "N"},
                                                         {"mean_dt", "s"}};

std::string_view unit_of(std::string_view key) {
  if (key.ends_with("_J")) return "J";
  if (key.ends_with("_s")) return "s";
  const auto unit = units.find(key);
  return unit == units.end() ? "" : unit->second;
}

/// "boundary particles" of boundary_particles, "wall" of wall_s; file names stay as they are.
std::string label_of(std::string key) {
  if (key.find('.') != std::string::npos) return key;
  if (key.ends_with("_s") || key.ends_with("_J")) key.resize(key.size() - 2);
  for (char& c : key) {
    if (c == '_') c = ' ';
  }
  return key;
}

/// A single value; empty for tables, arrays and empty texts.
std::string text_of(const TomlNode& node) {
  return std::visit(
      [](const auto& value) -> std::string {
        using T = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<T, double>) {
          return fmt::format("{:.9g}", value);
        } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, bool> ||
                             std::is_same_v<T, std::int64_t>) {
          return fmt::format("{}", value);
        } else {
          return "";
        }
      },
      node.value);
}

std::string table_text(const std::string& heading, const TomlTable& table) {
  std::string text = fmt::format("\n{}\n", heading);
  std::size_t width = 20;
  if (heading == "quantities")
    for (const auto& [key, node] : table) width = std::max(width, key.size());
  for (const auto& [key, node] : table) {
    const std::string value = text_of(node);
    if (value.empty()) continue;
    const std::string_view unit = unit_of(key);
    text += fmt::format("  {:<{}} {}{}{}\n", label_of(key), width, value, unit.empty() ? "" : " ",
                        unit);
  }
  return text;
}

/// The passes of the solver, a line each.
std::string passes_text(const TomlArray& passes) {
  std::string text = "\npasses                      seconds    share      calls    pairs/s\n";
  for (const TomlNode& item : passes) {
    const auto* pass = std::get_if<TomlTable>(&item.value);
    if (!pass) continue;
    const auto value = [&](const char* key) {
      const TomlNode* node = find(*pass, key);
      return node ? text_of(*node) : "-";
    };
    text += fmt::format("  {:<20} {:>12} {:>8} {:>10} {:>10}\n", value("name"), value("seconds"),
                        value("share"), value("calls"), value("pairs_per_s"));
  }
  return text;
}

struct FileTotal {
  std::size_t files = 0;
  std::uintmax_t bytes = 0;
};

FileTotal total_of(const fs::path& path) {
  std::error_code error;
  FileTotal total;
  const auto add = [&](const fs::path& file) {
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) return;
    ++total.files;
    total.bytes += size;
  };
  if (fs::is_regular_file(path, error)) add(path);
  if (!fs::is_directory(path, error)) return total;
  fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (entry->is_regular_file(error)) add(entry->path());
  }
  return total;
}

std::string size_text(std::uintmax_t bytes) {
  constexpr std::array<std::string_view, 4> names{"B", "kB", "MB", "GB"};
  auto size = static_cast<double>(bytes);
  std::size_t k = 0;
  for (; size >= 1000 && k + 1 < names.size(); ++k) size /= 1000;
  return fmt::format("{:.{}f} {}", size, k == 0 ? 0 : 1, names[k]);
}

std::string files_text(const fs::path& folder) {
  constexpr std::array<std::string_view, 9> parts{"index.html", "case.toml", "manifest.toml",
                                                  "maps",       "series",    "frames",
                                                  "view",       "pictures",  "checkpoint"};
  std::string text = "\nfiles\n";
  for (const std::string_view part : parts) {
    const FileTotal total = total_of(folder / part);
    if (total.files == 0) continue;
    std::error_code error;
    const bool is_folder = fs::is_directory(folder / part, error);
    text += fmt::format("  {:<20} {:>9}{}\n", fmt::format("{}{}", part, is_folder ? "/" : ""),
                        size_text(total.bytes),
                        is_folder ? fmt::format(" in {} files", total.files) : "");
  }
  return text;
}

}  // namespace

std::string manifest_text(const TomlTable& manifest) {
  std::string text;
  for (const auto& [key, node] : manifest) {
    if (const auto* table = std::get_if<TomlTable>(&node.value)) text += table_text(key, *table);
    if (const auto* list = std::get_if<TomlArray>(&node.value)) {
      if (key == "passes") text += passes_text(*list);
      for (const TomlNode& item : *list) {
        const auto* table = std::get_if<TomlTable>(&item.value);
        if (table && key != "passes") text += table_text(key, *table);
      }
    }
  }
  return text;
}

std::string run_info_text(const fs::path& folder) {
  return folder.string() + "\n" + manifest_text(read_manifest(folder)) + files_text(folder);
}

}  // namespace sabo
