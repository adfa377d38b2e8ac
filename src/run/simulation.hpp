#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "analysis/front.hpp"
#include "analysis/volume_ledger.hpp"
#include "case/case.hpp"
#include "run/branch.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// How a run stands, for the progress line.
struct RunProgress {
  double time = 0;      ///< simulated, s
  double duration = 0;  ///< to simulate, s
  double wall = 0;      ///< since the start, s
  std::size_t steps = 0;
  double dt = 0;  ///< of the last step, s
  std::size_t fluid = 0;
  std::size_t boundary = 0;
  double fastest = 0;  ///< m/s
  FrontRow front;
  VolumeRow volumes;
};

enum class RunEnd { finished, interrupted, failed };
template <>
struct Words<RunEnd> {
  static constexpr std::array<std::string_view, 3> list{"finished", "interrupted", "failed"};
};

struct RunResult {
  RunEnd end = RunEnd::finished;
  std::string reason;                ///< of a failure, or of an end before the case's duration
  std::filesystem::path index;       ///< page to open; empty if it could not be written
  std::vector<std::string> summary;  ///< lines to print: volumes, resolution, what to be aware of
};

struct RunOptions {
  std::filesystem::path folder;  ///< absent, empty, or with a run as `former` says
  FormerRun former = FormerRun::kept;
  std::function<void(const RunProgress&)> on_progress;  ///< called after steps
  const std::atomic<bool>* stop = nullptr;              ///< set by a signal handler
  bool keeps_checkpoint = true;                         ///< the last one, when the run has finished
  /// Called with a line that the user should see: where a run goes on, a damaged checkpoint.
  std::function<void(const std::string&)> on_note = {};
  /// Where it starts from, if not from the release.
  std::optional<BranchOrigin> branch = {};
  double progress_interval = 0.2;  ///< of computing between two calls of on_progress, s
};

/// Runs a case and writes its run folder. Throws CaseError and, before anything was simulated,
/// RunError; later failures are part of the result, with all outputs up to them written.
RunResult run_case(const Case& c, const RunOptions& options);

}  // namespace sabo
