#pragma once

#include "math/vec3.hpp"

namespace sabo {

/// The part of a particle's kernel that lies in a wall, see HalfSpace.
struct WallShare {
  double share = 0;
  Vec3d gradient;  ///< 1/m, into the wall
  Vec3d velocity;  ///< of the wall, times share, m/s
};

}  // namespace sabo
