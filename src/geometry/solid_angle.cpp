#include "geometry/solid_angle.hpp"

#include <cmath>
#include <numbers>

namespace sabo {

double solid_angle_share(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& from) {
  const Vec3d u = a - from, v = b - from, w = c - from;
  const double lu = norm(u), lv = norm(v), lw = norm(w);
  const double upper = dot(u, cross(v, w));
  const double lower = lu * lv * lw + dot(u, v) * lw + dot(v, w) * lu + dot(w, u) * lv;
  if (upper == 0) return 0;
  return std::atan2(upper, lower) / (2 * std::numbers::pi);
}

double winding_number(const TriangleMesh& mesh, const Vec3d& point) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += solid_angle_share(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), point);
  return sum;
}

}  // namespace sabo
