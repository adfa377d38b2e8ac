#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "run/batch_record.hpp"
#include "run/simulation.hpp"

namespace sabo {

// Runs of a case that belong together, one after the other: studies and sweeps.

struct BatchOptions {
  std::filesystem::path folder;                    ///< of all; each run has one below it
  std::function<void(const std::string&)> on_run;  ///< told of each run before it starts
  std::function<void(const RunProgress&)> on_progress;
  const std::atomic<bool>* stop = nullptr;  ///< set by a signal handler
};

struct BatchResult {
  RunEnd end = RunEnd::finished;     ///< failed when any run has
  std::string reason;                ///< of a failure
  std::filesystem::path index;       ///< page to open; empty when no run has finished
  std::vector<std::string> summary;  ///< lines to print
};

struct BatchRun {
  std::string folder;  ///< below that of the batch
  Case c;
};

/// Makes the folder of a batch and marks it by a file `KIND.toml`. Throws CaseError when it holds
/// anything else.
void prepare_batch(const std::filesystem::path& folder, const std::string& kind);

/// Makes the runs; one entry per run, none where it was not made or failed. A run that the folder
/// holds already, of the same case, inputs and version, is not repeated; so a batch that was
/// interrupted goes on where it stopped. When a run fails the others are made all the same. Sets
/// end and reason of the result.
std::vector<std::optional<BatchRecord>> make_runs(const std::vector<BatchRun>& runs,
                                                  const BatchOptions& options, BatchResult& result);

/// A warning when runs are missing, else "".
std::string missing_runs_text(const std::vector<std::optional<BatchRecord>>& records,
                              const BatchResult& result);

}  // namespace sabo
