#pragma once

#include <filesystem>
#include <vector>

namespace sabo {

/// Draws the flow of a finished run at some times: depth, speed and pressure, from above and in
/// perspective, with one colour scale for each quantity. Of each time (s) the nearest frame is
/// taken; without times six frames over the run. Reads the frames of the folder and the inputs that
/// its case names; writes pictures/state_*.svg and the page states.html, whose path it returns.
/// Throws CaseError when the folder is no run, an input is gone or a time lies beyond the run.
std::filesystem::path draw_states(const std::filesystem::path& run_folder,
                                  const std::vector<double>& times);

}  // namespace sabo
