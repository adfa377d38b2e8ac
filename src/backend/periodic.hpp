#pragma once

#include <array>
#include <cmath>

#include "base/host_device.hpp"
#include "math/vec3.hpp"

namespace sabo {

/// Periodic directions. The period vector of axis a may lean: on a tilted bed that of x has a
/// vertical component. An axis whose period is zero is not periodic.
struct Periodic {
  Vec3d origin;                 ///< lower corner of the primary cell, m
  std::array<Vec3d, 3> period;  ///< of x, y, z; period[a] has a positive component a

  SABO_HD static double along(const Vec3d& v, int axis) {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
  }
  SABO_HD bool on(int axis) const { return along(period[axis], axis) > 0; }
  SABO_HD bool any() const { return on(0) || on(1) || on(2); }

  /// The image of x_i - x_j with the smallest components.
  SABO_HD Vec3d nearest(Vec3d x) const {
    for (int axis = 0; axis < 3; ++axis)
      if (on(axis)) x -= std::rint(along(x, axis) / along(period[axis], axis)) * period[axis];
    return x;
  }

  /// The image of a position inside the primary cell.
  SABO_HD Vec3d wrapped(Vec3d x) const {
    for (int axis = 0; axis < 3; ++axis)
      if (on(axis))
        x -= std::floor(along(x - origin, axis) / along(period[axis], axis)) * period[axis];
    return x;
  }
};

}  // namespace sabo
