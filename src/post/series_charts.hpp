#pragma once

#include <string>
#include <vector>

#include "post/finished_run.hpp"

namespace sabo {

/// A chart of one column of a series in two runs.
struct PairedChart {
  std::string file;  ///< of the picture, e.g. "front_velocity.svg"
  std::string svg;
  std::string caption;  ///< names the series it is from
};

/// Charts of what both runs measured: front, discharge, depth and speed at sections and gauges,
/// volumes at dams, forces on structures. `names` are those of the two runs.
std::vector<PairedChart> paired_charts(const FinishedRun& a, const FinishedRun& b,
                                       const std::vector<std::string>& names);

}  // namespace sabo
