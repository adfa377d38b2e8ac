#include "geometry/plan_outline.hpp"

#include <algorithm>
#include <utility>

#include "math/turn.hpp"

namespace sabo {

// Andrew's monotone chain (1979).
std::vector<Vec3d> plan_outline(const TriangleMesh& mesh) {
  std::vector<Vec3d> points;
  for (const Vec3d& v : mesh.vertices) points.push_back({v.x, v.y, 0});
  std::sort(points.begin(), points.end(), [](const Vec3d& a, const Vec3d& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec3d> outline;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = outline.size();
    for (const Vec3d& p : points) {
      while (outline.size() >= start + 2 && turn(outline.end()[-2], outline.back(), p) <= 0)
        outline.pop_back();
      outline.push_back(p);
    }
    outline.pop_back();  // it begins the other side
    std::reverse(points.begin(), points.end());
  }
  return outline;
}

}  // namespace sabo
