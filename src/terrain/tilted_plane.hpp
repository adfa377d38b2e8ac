#pragma once

#include "terrain/raster.hpp"

namespace sabo {

/// A rectangle of level or tilted ground.
struct TiltedPlane {
  double west = 0, south = 0, east = 0, north = 0;  ///< m
  double lowest = 0;                                ///< elevation of its lowest corner, m
  double fall = 0;                                  ///< m per m
  double azimuth = 0;                               ///< of its fall, clockwise from north, rad
};

/// Its elevations. Centres of cells lie on the edges of the rectangle, so that a surface between
/// them covers it exactly; cells are `cell` (m) wide or a little less, in each direction by itself.
Raster raster_of(const TiltedPlane& plane, double cell);

}  // namespace sabo
