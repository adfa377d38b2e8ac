#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/output/csv.hpp"
#include "io/output/folder_lock.hpp"

namespace sabo {

/// What becomes of a run that the folder of another one holds already.
enum class FormerRun {
  kept,      ///< the new one is refused
  replaced,  ///< its files are removed
  resumed    ///< there must be one, and it goes on
};

/// The folder of one run and the places of its files (product of `sabo run`). While it lives no
/// other run can write there.
class RunFolder {
 public:
  /// Makes the folder, and a manifest that says that the run goes on. Removes what other commands
  /// made of a former run, and its own results too where it is replaced. Throws CaseError if it
  /// holds files that are not those of a run, another run than `former` says, or one that is being
  /// written; RunError if it cannot be made.
  RunFolder(std::filesystem::path folder, FormerRun former);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path maps() const { return root_ / "maps"; }
  std::filesystem::path series() const { return root_ / "series"; }
  /// A table of the run; it goes on where the run does.
  TableFile series_file(const char* name) const { return {series() / name, goes_on_}; }
  std::filesystem::path frames() const { return root_ / "frames"; }
  std::filesystem::path checkpoints() const { return root_ / "checkpoint"; }
  std::filesystem::path pictures() const { return root_ / "pictures"; }
  std::filesystem::path view() const { return root_ / "view"; }
  std::filesystem::path manifest() const { return root_ / "manifest.toml"; }
  std::filesystem::path index() const { return root_ / "index.html"; }
  std::filesystem::path states() const { return root_ / "states.html"; }
  std::filesystem::path report() const { return root_ / "report.html"; }
  std::filesystem::path japanese_report() const { return root_ / "report_ja.html"; }

  /// Writes a manifest that says no more than how the run stands: "running", "failed".
  void set_state(const std::string& end, const std::string& reason) const;

 private:
  bool holds_run() const;
  void remove_made_of_results() const;
  void remove_results() const;
  void remove_parts() const;

  std::filesystem::path root_;
  bool goes_on_ = false;
  std::optional<FolderLock> lock_;
};

}  // namespace sabo
