#pragma once

#include "terrain/surface.hpp"

namespace sabo {

/// Elevation, m, of the surface moved into the ground by `depth` (m), under (x, y): below it every
/// point is farther than `depth` from the surface, above it none is. What lies between the ground
/// and this is the shell of that thickness, also under cliffs and sharp edges; on a plane it is
/// `depth` / cos(slope) below the ground. Exact; takes time with the triangles within `depth`.
double inset_height(const Surface& surface, double x, double y, double depth);

}  // namespace sabo
