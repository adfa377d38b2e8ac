#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "post/compare_runs.hpp"

namespace sabo {

/// What stands in for [observed] of the run's case.
struct ObservedOptions {
  std::filesystem::path file;       ///< raster of depths or polygons; "" for that of the case
  std::string map;                  ///< "deposit" or "peak_depth"; "" for that of the case
  std::optional<double> wet_depth;  ///< m
};

/// Sets a finished run beside what a survey found: areas hit, missed and falsely reached with their
/// scores, depth error (of a raster) in all and by zone, run-out along the path and centroids,
/// arrival times. Writes to `output`; "" for the folder `observed` within the run. Throws CaseError
/// when the case says of no survey, or a file of it cannot be used.
PostResult compare_observed(const std::filesystem::path& run, const ObservedOptions& options,
                            const std::filesystem::path& output);

}  // namespace sabo
