#pragma once

#include <filesystem>

#include "report/phrases.hpp"

namespace sabo {

struct ReportOptions {
  std::filesystem::path output = {};  ///< "" for report.html (report_ja.html) in the run folder
  Language language = Language::en;
  std::filesystem::path other = {};  ///< run to compare with; "" for none
  double sharpness = 2;              ///< pixels of a map for one px of the page
};

/// Writes the report of a run: one HTML file that needs nothing else. Reads the run folder only, of
/// a run that finished, was interrupted or failed; what is missing there is said in the report.
/// Returns the file. Throws CaseError if a folder is not that of a run, RunError if the file cannot
/// be written.
std::filesystem::path write_report(const std::filesystem::path& run_folder,
                                   const ReportOptions& options);

}  // namespace sabo
