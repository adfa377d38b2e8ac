#pragma once

#include "math/vec3.hpp"

namespace sabo {

/// Twice the signed area of a triangle in plan, m2: positive where c is to the left of a -> b, that
/// is counterclockwise.
inline double turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace sabo
