#pragma once

#include "terrain/raster.hpp"

namespace sabo {

/// How well a run resolved its flow: depth over particle spacing, on the cells that were wet.
struct ResolutionGuard {
  /// A layer of fewer particles than this has walls for most of its neighbours.
  static constexpr double enough_layers = 4;
  /// Below this a layer is barely resolved: the two rows at its faces are half of it.
  static constexpr double good_layers = 5;

  double wet_area = 0;       ///< m2
  double median_layers = 0;  ///< median of peak depth / spacing; 0 when nothing was wet
  double thin_share = 0;     ///< share of the wet area with fewer than `enough_layers`
  double barely_share = 0;   ///< with `enough_layers` or more, but fewer than `good_layers`

  bool is_too_coarse() const { return median_layers < enough_layers; }
  bool is_barely_enough() const { return !is_too_coarse() && median_layers < good_layers; }
};

/// From a map of peak depth (m; NaN outside the domain) and the particle spacing (m). A cell is wet
/// above wet_depth().
ResolutionGuard resolution_guard(const Raster& peak_depth, double spacing);

/// Peak depth over spacing, particles; NaN where the ground was never wet and outside the domain.
Raster layers_map(const Raster& peak_depth, double spacing);

}  // namespace sabo
