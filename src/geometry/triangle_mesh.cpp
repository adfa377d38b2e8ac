#include "geometry/triangle_mesh.hpp"

#include <algorithm>

namespace sabo {

Bounds bounds_of(const TriangleMesh& mesh) {
  Bounds bounds{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vec3d& v : mesh.vertices) {
    bounds.low = {std::min(bounds.low.x, v.x), std::min(bounds.low.y, v.y),
                  std::min(bounds.low.z, v.z)};
    bounds.high = {std::max(bounds.high.x, v.x), std::max(bounds.high.y, v.y),
                   std::max(bounds.high.z, v.z)};
  }
  return bounds;
}

Vec3d area_vector(const TriangleMesh& mesh, std::size_t triangle) {
  const Vec3d& a = mesh.corner(triangle, 0);
  return 0.5 * cross(mesh.corner(triangle, 1) - a, mesh.corner(triangle, 2) - a);
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += norm(area_vector(mesh, t));
  return sum;
}

double volume(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  // From a point nearby, so that large coordinates do not take digits away.
  const Vec3d origin = mesh.corner(0, 0);
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += dot(mesh.corner(t, 0) - origin, area_vector(mesh, t)) / 3;
  return sum;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& [a, b, c] : more.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
}

}  // namespace sabo
