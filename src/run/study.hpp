#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "run/simulation.hpp"
#include "run/study_plan.hpp"

namespace sabo {

struct StudyOptions {
  std::filesystem::path folder;                    ///< of the study; each run has one below it
  std::function<void(const std::string&)> on_run;  ///< told of each run before it starts
  std::function<void(const RunProgress&)> on_progress;
  const std::atomic<bool>* stop = nullptr;  ///< set by a signal handler
};

struct StudyResult {
  RunEnd end = RunEnd::finished;     ///< failed when any run has
  std::string reason;                ///< of a failure
  std::filesystem::path index;       ///< page to open; empty when no run has finished
  std::vector<std::string> summary;  ///< lines to print
};

/// Runs a case at each spacing and writes what the results say about the spacing of zero. A run
/// that the folder holds already, of the same case, inputs and version, is not repeated; so a study
/// that was interrupted goes on where it stopped. When a run fails the others are made all the
/// same. Throws CaseError, and RunError when the tables cannot be written.
StudyResult run_study(const StudyRequest& request, const StudyOptions& options);

}  // namespace sabo
