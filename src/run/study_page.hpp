#pragma once

#include <filesystem>
#include <string>

#include "case/case.hpp"
#include "run/study_table.hpp"

namespace sabo {

/// Writes table.csv, runs.csv, study.toml, a chart for each quantity and index.html into the folder
/// of a study; the warnings stand at the head of the page. Returns the page. Throws RunError.
std::filesystem::path write_study(const std::filesystem::path& folder, const Case& c,
                                  const std::vector<BatchRecord>& records, const StudyTable& table,
                                  const std::vector<std::string>& warnings);

}  // namespace sabo
