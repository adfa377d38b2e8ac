#pragma once

#include <vector>

#include "analysis/columns.hpp"

namespace sabo {

/// Maps of a run on the grid of the DEM. A cell counts as wet above wet_depth().
class FlowMaps {
 public:
  /// Cells where `elevation` is NaN are outside the domain. `spacing` in m, density in kg/m3.
  FlowMaps(const Raster& elevation, double spacing, double reference_density);

  /// Takes in the particles as they are at `time` (s); times must not decrease. Peaks miss cells
  /// that the fastest particle passes between two calls.
  void update(double time, const Particles& particles);

  // All maps are NaN outside the domain.
  Raster peak_depth() const;     ///< greatest depth so far, m
  Raster peak_speed() const;     ///< greatest mass-weighted mean speed while wet, m/s
  Raster peak_pressure() const;  ///< greatest pressure of a particle in the column while wet, Pa
  Raster peak_momentum_flux() const;  ///< greatest density x depth x speed^2 while wet, N/m
  Raster arrival_time() const;  ///< time at which the cell was first wet, s; NaN where it never was
  Raster depth() const;         ///< depth at the last update, m

  /// Without the depth of the last update.
  template <class Archive>
  void archive(Archive& a) {
    for (std::vector<double>* map :
         {&peak_depth_, &peak_speed_, &peak_pressure_, &peak_momentum_flux_, &arrival_time_})
      a.fixed(*map);
  }

 private:
  Columns columns_;
  std::vector<double> peak_depth_;
  std::vector<double> peak_speed_;
  std::vector<double> peak_pressure_;
  std::vector<double> peak_momentum_flux_;
  double density_;
  std::vector<double> arrival_time_;
};

}  // namespace sabo
