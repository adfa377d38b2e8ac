#pragma once

#include <cstddef>
#include <vector>

#include "terrain/raster.hpp"

namespace sabo {

/// Areas of a simulated and an observed footprint, m2, and scores of them. Names as in Jolliffe &
/// Stephenson, Forecast Verification (2nd ed. 2012), chapter 3, with areas in the place of counts.
/// A score is not finite where its denominator is zero.
struct FootprintScore {
  double hit = 0;          ///< wet in both
  double miss = 0;         ///< wet in the observation only
  double false_alarm = 0;  ///< wet in the simulation only

  double observed() const { return hit + miss; }
  double simulated() const { return hit + false_alarm; }
  /// Critical success index (threat score): hit / (hit + miss + false alarm). Of areas it is the
  /// same as intersection over union (Jaccard).
  double csi() const { return hit / (hit + miss + false_alarm); }
  /// Hit over simulated: 1 - false alarm ratio.
  double precision() const { return hit / simulated(); }
  /// Hit over observed: probability of detection.
  double recall() const { return hit / observed(); }
  /// Simulated over observed area (frequency bias).
  double bias() const { return simulated() / observed(); }

  /// Positive less negative less missing accuracy (Scheidl & Rickenmann 2010, Earth Surf. Process.
  /// Landforms 35, 157-173): 1 for a perfect match.
  double omega() const { return (hit - false_alarm - miss) / observed(); }
};

/// Cell by cell, on one grid; NaN counts as dry.
enum class FootprintCell { dry = 0, hit = 1, miss = 2, false_alarm = 3 };

/// Depths (m) of a simulation and of an observation on one grid; a cell is wet above `wet` (m). A
/// mask is the same with 0 and 1.
struct FootprintPair {
  const Raster& simulated;
  const Raster& observed;
  double simulated_wet = 0;
  double observed_wet = 0;

  FootprintCell at(std::size_t cell) const {
    const bool is_simulated = simulated.values[cell] > simulated_wet;
    const bool is_observed = observed.values[cell] > observed_wet;
    if (is_simulated) return is_observed ? FootprintCell::hit : FootprintCell::false_alarm;
    return is_observed ? FootprintCell::miss : FootprintCell::dry;
  }
};

/// Scores over the cells whose indices are given.
FootprintScore footprint_score(const FootprintPair& pair, const std::vector<std::size_t>& cells);

/// Simulated minus observed depth, m, over the cells where both are wet.
struct DepthError {
  double area = 0;  ///< m2
  double mean = 0;  ///< bias
  double mean_absolute = 0;
  double root_mean_square = 0;
};

/// Zeros when no cell is wet in both.
DepthError depth_error(const FootprintPair& pair, const std::vector<std::size_t>& cells);

}  // namespace sabo
