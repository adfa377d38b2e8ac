#pragma once

#include <string>
#include <vector>

#include "post/compare_observed.hpp"
#include "post/finished_run.hpp"

#include "case/observed_case.hpp"

namespace sabo {

/// What a survey found, on the grid of the run's maps.
struct ObservedData {
  RunMap simulated;  ///< the map of the run that is set beside it, m
  Raster observed;   ///< m, 0 where dry; of an outline 1 within it
  bool has_depths = false;
  double wet = 0.1;                ///< m, threshold of the run
  std::vector<std::size_t> cells;  ///< that are compared: in the domain and in the surveyed area
  std::vector<std::string> notes;  ///< what was done to the data

  double observed_wet() const { return has_depths ? wet : 0.5; }
};

/// [observed] of the run's case with what the options put in its place. Throws CaseError when
/// neither names a footprint or arrivals.
ObservedCase observed_case(const FinishedRun& run, const ObservedOptions& options);

/// Reads the footprint that the case names. Throws CaseError at the key or file.
ObservedData read_observed(const FinishedRun& run, const ObservedCase& observed);

}  // namespace sabo
