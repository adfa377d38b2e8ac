#pragma once

#include <functional>
#include <string>
#include <vector>

#include "run/checkpoints.hpp"

namespace sabo {

/// The checkpoints from which the run in a folder can go on with a case, the latest first. Throws
/// CaseError when there are none, when the run has finished, or when the case is another one: only
/// duration, threads, intervals of checkpoints, title, note and stop_at_rest may differ. Of damaged
/// checkpoints `tell` hears a line.
std::vector<FoundCheckpoint> checkpoints_to_resume(
    const Case& c, const std::filesystem::path& run_folder,
    const std::function<void(const std::string&)>& tell);

/// The case that a checkpoint was written by. Throws RunError if it cannot be read.
Case case_of(const FoundCheckpoint& checkpoint);

}  // namespace sabo
