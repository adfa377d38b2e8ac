#pragma once

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// The way down from (x, y) to the border of the data, or to the lowest cell of all in a closed
/// basin: steepest descent from cell to cell once all pits are filled, smoothed over some cells so
/// that the length is that of the valley and not that of a staircase. What climbs after the lowest
/// place is cut off. Vertices stand about three cells apart and carry the elevation. Throws
/// CaseError if (x, y) is outside the data or there is no way down.
Polyline steepest_descent(const Raster& elevation, double x, double y);

}  // namespace sabo
