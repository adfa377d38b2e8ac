#pragma once

#include "terrain/raster.hpp"

namespace sabo {

/// Value between cell centres; a neighbour without data counts as `missing`. NaN where the result
/// is, and outside the grid.
double bilinear(const Raster& raster, double x, double y, double missing);

}  // namespace sabo
