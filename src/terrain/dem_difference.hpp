#pragma once

#include <vector>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Surfaces before and after an event, each on a grid of its own, in the frame of the ground.
struct DemPair {
  Raster before;
  Raster after;
};

/// Thickness of what left, m, on the cells of `ground`: before - after, both taken bilinearly at
/// the cell's centre, where it is above `least` and, if there are polygons, inside one of them.
/// No data elsewhere, and where the ground or either surface has none.
Raster lost_thickness(const DemPair& pair, const Raster& ground, const std::vector<Polygon>& within,
                      double least);

/// Lowers the ground to the surface after the event wherever there is a thickness, never raises it.
/// Returns the volume taken away, m3.
double lower_to_after(const DemPair& pair, const Raster& thickness, Raster& ground);

}  // namespace sabo
