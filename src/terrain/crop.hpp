#pragma once

#include "terrain/raster.hpp"

namespace sabo {

/// The cells of a raster that a window touches, aligned with the original grid; the window is in
/// the coordinates of the raster. Throws CaseError("terrain.crop") if the window misses the raster
/// or leaves fewer than 2 x 2 cells.
Raster cropped(const Raster& raster, double west, double south, double east, double north);

}  // namespace sabo
