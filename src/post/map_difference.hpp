#pragma once

#include <string>

#include "post/finished_run.hpp"

namespace sabo {

/// A map on the grid of another one.
struct AlignedMap {
  RunMap map;
  std::string note;  ///< what was done, e.g. "resampled from 5 x 5 m cells"; "" for nothing
};

/// Resamples a map (bilinear; means where its cells are finer) when its grid is not that of
/// `like`. Cells that it does not cover become NaN. Throws CaseError when the two are in different
/// coordinate systems, or one has none.
AlignedMap aligned(RunMap map, const RunMap& like);

/// b - a on one grid; NaN where either has no data.
Raster difference(const Raster& a, const Raster& b);

/// Sums over the cells of a difference of maps.
struct DifferenceSummary {
  double greatest_rise = 0;  ///< not negative
  double greatest_fall = 0;  ///< not positive
  double integral = 0;       ///< sum of value x cell area: m3 of a depth in m
  double mean_absolute = 0;  ///< over the cells where either map is above its threshold
  double area = 0;           ///< of those cells, m2
  /// A round number near the size of most differences (the 90th percentile of their magnitude over
  /// those cells); 1 where there are none.
  double scale = 1;
};

/// `threshold` is that above which a value of either map counts.
DifferenceSummary summary_of(const Raster& a, const Raster& b, double threshold);

/// The difference for a picture: NaN where neither map is above the threshold.
Raster shown_difference(const Raster& a, const Raster& b, double threshold);

}  // namespace sabo
