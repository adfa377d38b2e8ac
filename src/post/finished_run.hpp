#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "io/case_file/toml_tree.hpp"
#include "io/output/read_csv.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// A map of a run folder, in the coordinates of its CRS.
struct RunMap {
  std::string name;  ///< of its file without .tif, e.g. "pfd"
  Raster raster;
  std::string crs_wkt;
  std::string description;
  std::string unit;
};

/// The folder of a run that has been written, for reading.
class FinishedRun {
 public:
  /// Throws CaseError when it is not the folder of a run, or holds no maps.
  explicit FinishedRun(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  /// Of the folder, for people.
  const std::string& name() const { return name_; }
  /// A table of the manifest; empty when it has none of that name.
  const TomlTable& table(std::string_view name) const { return table_at(manifest_, name); }
  /// The tables of a list in the manifest.
  std::vector<const TomlTable*> tables(std::string_view name) const {
    return tables_at(manifest_, name);
  }
  /// How it ended: "finished", "interrupted", ...
  std::string end() const;
  std::string version() const;
  /// Time of the flow at its end, s, where the manifest says it.
  std::optional<double> simulated() const;

  /// As far as its file can be read; see case_problem().
  const Case& run_case() const { return case_; }
  /// Why the case cannot be made again, e.g. that an input file is gone; "" when nothing is wrong.
  const std::string& case_problem() const { return case_problem_; }
  /// Throws CaseError where it cannot be read at all, and defaults would stand for it.
  void need_case() const;
  /// Depth above which a cell counted as wet, m.
  double wet_depth() const;

  /// Names of the maps, in order; without those of ground and release.
  const std::vector<std::string>& maps() const { return maps_; }
  bool has_map(std::string_view name) const;
  /// Throws CaseError when the run has no such map or it cannot be read.
  RunMap map(const std::string& name) const;
  /// Elevation, m.
  RunMap ground() const { return map("ground"); }
  /// A series by the name of its file without .csv; nothing when there is none.
  std::optional<NumberTable> series(const std::string& name) const;

 private:
  std::filesystem::path folder_;
  std::string name_;
  TomlTable manifest_;
  Case case_;
  std::string case_problem_;
  std::vector<std::string> maps_;
};

/// Names by which two runs or more can be told apart: those of their folders, with the folder above
/// where they are equal.
std::vector<std::string> names_of(const std::vector<FinishedRun>& runs);

}  // namespace sabo
