#pragma once

#include <algorithm>
#include <array>

#include "math/vec3.hpp"

namespace sabo {

/// Nearest point on the straight piece from a to b.
inline Vec3d nearest_on_segment(const Vec3d& point, const Vec3d& a, const Vec3d& b) {
  const Vec3d along = b - a;
  return a + std::clamp(dot(point - a, along) / dot(along, along), 0.0, 1.0) * along;
}

/// Nearest point on a triangle, which must not be degenerate.
inline Vec3d nearest_on_triangle(const Vec3d& point, const std::array<Vec3d, 3>& corners) {
  const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  Vec3d nearest;
  double nearest_distance = -1;
  for (int k = 0; k < 3; ++k) {
    const Vec3d& a = corners[k];
    const Vec3d& b = corners[(k + 1) % 3];
    // Only an edge that the point lies beyond can hold the nearest point.
    if (dot(cross(normal, b - a), point - a) >= 0) continue;
    const Vec3d candidate = nearest_on_segment(point, a, b);
    const double distance = dot(point - candidate, point - candidate);
    if (nearest_distance >= 0 && distance >= nearest_distance) continue;
    nearest_distance = distance;
    nearest = candidate;
  }
  if (nearest_distance >= 0) return nearest;
  return point - (dot(point - corners[0], normal) / dot(normal, normal)) * normal;
}

}  // namespace sabo
