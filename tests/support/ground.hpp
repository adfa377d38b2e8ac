#pragma once

#include <cmath>
#include <vector>

#include "terrain/ground.hpp"

namespace sabo::test {

/// Signed distance to the surface, m: positive above. Exact within `reach` (m), beyond that `reach`
/// in magnitude.
inline double distance_to(const Surface& surface, const Vec3d& point, double reach) {
  const auto found = surface.nearest(point, reach);
  return std::copysign(found ? found->distance : reach, point.z - surface.height(point.x, point.y));
}

/// Lets the boundary follow the fluid; whether anything had to change.
inline bool follow(Ground& ground, const std::vector<Vec3d>& fluid, double reach,
                   Particles& boundary) {
  const BoundaryChange change = ground.follow(fluid, reach);
  change.apply_to(boundary);
  return !change.is_empty();
}

}  // namespace sabo::test
