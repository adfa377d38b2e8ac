#pragma once

#include "math/vec3.hpp"

namespace sabo {

/// How full a particle's kernel is, by the places of the particles alone.
struct Filling {
  double share = 0;  ///< sum of V W over all particles, itself included: 1 inside
  Vec3d gradient;    ///< of the share, 1/m: away from a free surface
};

}  // namespace sabo
