#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "io/case_file/toml_tree.hpp"
#include "io/output/map_line.hpp"
#include "io/output/read_csv.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// A map of a run, in the coordinates of the DEM.
struct MapRecord {
  Raster raster;
  std::string unit;
  std::string crs;  ///< WKT, "" for none
};

/// The folder of a run as it stands, whatever is missing: its files are read when they are asked
/// for, and what cannot be read is kept in missing().
class RunRecord {
 public:
  /// Throws CaseError if the folder has no manifest that can be read.
  explicit RunRecord(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }

  // Of the manifest; nothing or empty where it does not say.
  std::optional<double> number(std::string_view table, std::string_view key) const;
  std::string text(std::string_view table, std::string_view key) const;
  bool is_true(std::string_view table, std::string_view key) const;
  /// A table, empty without it.
  TomlTable table(std::string_view name) const;
  /// The tables of a list, [[volumes]].
  std::vector<TomlTable> list(std::string_view name) const;
  /// [quantities], e.g. "front run-out [m]".
  std::optional<double> quantity(const std::string& label) const {
    return number("quantities", label);
  }

  /// The case; files that it names may be gone, then their keys are empty. Nothing if the run has
  /// no case.toml that this version can read.
  const std::optional<Case>& described() const { return case_; }
  /// A text of case.toml as it stands there, e.g. a file name; "" without it.
  std::string written(std::string_view table, std::string_view key) const;

  /// "front.csv" of series/; nullptr if it is not there.
  const NumberTable* series(const std::string& name);
  /// "dep" of maps/; nullptr if it is not there.
  const MapRecord* map(const std::string& name);
  /// Lines of the plan: path, structures, bodies, inflows, sections, zones.
  const std::vector<MapLine>& plan();
  /// Names of all maps that are there, sorted.
  std::vector<std::string> map_names() const;
  bool has(const std::string& file) const;
  /// Files that were asked for and could not be read.
  const std::set<std::string>& missing() const { return missing_; }

 private:
  void read_case_file();

  std::filesystem::path folder_;
  TomlTable manifest_;
  TomlTable case_text_;
  std::optional<Case> case_;
  std::map<std::string, std::optional<NumberTable>> series_;
  std::map<std::string, std::optional<MapRecord>> maps_;
  std::optional<std::vector<MapLine>> plan_;
  std::set<std::string> missing_;
};

}  // namespace sabo
