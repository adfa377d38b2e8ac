#pragma once

#include "math/vec3.hpp"

namespace sabo {

/// How a particle was shifted over a step.
struct Shift {
  Vec3d by;           ///< m
  double filled = 0;  ///< share of its kernel that its shift and those of its neighbours fill
};

}  // namespace sabo
