#pragma once

#include <vector>

#include "terrain/ground.hpp"

namespace sabo::test {

/// Lets the boundary follow the fluid; whether anything had to change.
inline bool follow(Ground& ground, const std::vector<Vec3d>& fluid, double reach,
                   Particles& boundary) {
  const BoundaryChange change = ground.follow(fluid, reach);
  change.apply_to(boundary);
  return !change.is_empty();
}

}  // namespace sabo::test
