#pragma once

#include <cstddef>
#include <vector>

#include "analysis/spreader.hpp"
#include "particles/particles.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Maps of a run on the grid of the DEM. Depth is vertical: the volume over a cell (mass /
/// reference density, see Spreader) by its area, so that the sum of depth x area is the particles'
/// volume to rounding. An update costs as much as the particles and their footprints, whatever the
/// grid.
class FlowMaps {
 public:
  /// Depth from which a cell counts as wet, m: for arrival, and for speed, which means nothing
  /// where the edge of a footprint leaves a film.
  static constexpr double wet_depth = 0.05;

  /// Cells where `elevation` is NaN are outside the domain. `spacing` in m, density in kg/m3.
  FlowMaps(const Raster& elevation, double spacing, double reference_density);

  /// Takes in the particles as they are at `time` (s); times must not decrease. Peaks miss cells
  /// that the fastest particle passes between two calls.
  void update(double time, const Particles& particles);

  // All maps are NaN outside the domain.
  Raster peak_depth() const;    ///< greatest depth so far, m
  Raster peak_speed() const;    ///< greatest mass-weighted mean speed while wet, m/s
  Raster arrival_time() const;  ///< time at which the cell was first wet, s; NaN where it never was
  Raster depth() const;         ///< depth at the last update, m

 private:
  Raster masked(const std::vector<double>& values) const;

  Spreader spreader_;
  double reference_density_;
  std::vector<double> volume_;        // m3 in the cell at the last update
  std::vector<double> transport_;     // volume x speed, m4/s
  std::vector<std::size_t> touched_;  // cells that hold volume
  std::vector<double> peak_depth_;
  std::vector<double> peak_speed_;
  std::vector<double> arrival_time_;
};

}  // namespace sabo
