#pragma once

#include <filesystem>
#include <string>

namespace sabo {

/// The folder of one run and the places of its files (product of `sabo run`).
class RunFolder {
 public:
  /// Makes the folder. Throws CaseError if it holds files that are not those of a run, or a run
  /// that `overwrite` does not give up; RunError if it cannot be made.
  RunFolder(std::filesystem::path folder, bool overwrite);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path maps() const { return root_ / "maps"; }
  std::filesystem::path series() const { return root_ / "series"; }
  std::filesystem::path frames() const { return root_ / "frames"; }
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
  std::filesystem::path root_;
};

}  // namespace sabo
