#pragma once

#include "terrain/raster.hpp"

namespace sabo {

/// Thickness normal to the ground of what stands on it with a vertical depth: depth x cos(slope),
/// with the slope of the ground by central differences, one-sided beside cells without data. Both
/// rasters have the same grid, m; NaN where either is.
Raster bed_normal_thickness(const Raster& depth, const Raster& ground);

}  // namespace sabo
