#pragma once

#include "math/vec3.hpp"

namespace sabo {

/// The part of a particle's kernel that lies in a wall, see HalfSpace.
struct WallShare {
  double share = 0;
  Vec3d gradient;  ///< 1/m, into the wall
  Vec3d velocity;  ///< of the wall, times share, m/s
};

/// How the wall holds the flow at a particle.
struct WallGrip {
  Vec3d slope;      ///< normal out of the wall over the distance to it, 1/m
  double held = 0;  ///< resistance of the wall over that of one to which the flow sticks, 0 to 1
};

}  // namespace sabo
