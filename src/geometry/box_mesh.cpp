#include "geometry/box_mesh.hpp"

#include <cmath>

namespace sabo {
namespace {

// Corners 0 to 3 around the floor, anticlockwise from above, 4 to 7 over them.
constexpr Triangle floor_triangles[] = {{0, 2, 1}, {0, 3, 2}};
constexpr Triangle top_triangles[] = {{4, 5, 6}, {4, 6, 7}};
constexpr Triangle side_triangles[] = {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                       {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

std::vector<Vec3d> corners_of(const UprightBox& box) {
  const auto& [a, b] = std::pair{box.low, box.high};
  std::vector<Vec3d> corners;
  for (const double z : {a.z, b.z})
    for (const auto& [x, y] : {std::pair{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}})
      corners.push_back(box.turned({x, y, z}));
  return corners;
}

UprightBox outside_of(UprightBox box, double thickness, bool is_open) {
  box.low -= Vec3d{thickness, thickness, thickness};
  box.high += Vec3d{thickness, thickness, is_open ? 0 : thickness};
  return box;
}

}  // namespace

Vec3d UprightBox::turned(const Vec3d& point) const {
  const double cosine = std::cos(turn), sine = std::sin(turn);
  const Vec3d arm = point - pivot;
  return {pivot.x + cosine * arm.x - sine * arm.y, pivot.y + sine * arm.x + cosine * arm.y,
          point.z};
}

TriangleMesh box_mesh(const UprightBox& box) {
  TriangleMesh mesh{corners_of(box), {}};
  for (const auto& t : floor_triangles) mesh.triangles.push_back(t);
  for (const auto& t : top_triangles) mesh.triangles.push_back(t);
  for (const auto& t : side_triangles) mesh.triangles.push_back(t);
  return mesh;
}

std::vector<UprightBox> tank_boxes(const UprightBox& inside, double thickness, bool is_open) {
  const Vec3d& a = inside.low;
  const Vec3d& b = inside.high;
  const double t = thickness;
  const auto box = [&](const Vec3d& low, const Vec3d& high) {
    return UprightBox{low, high, inside.pivot, inside.turn};
  };
  std::vector<UprightBox> boxes{box({a.x - t, a.y - t, a.z - t}, {b.x + t, b.y + t, a.z}),
                                box({a.x - t, a.y - t, a.z}, {a.x, b.y + t, b.z}),
                                box({b.x, a.y - t, a.z}, {b.x + t, b.y + t, b.z}),
                                box({a.x, a.y - t, a.z}, {b.x, a.y, b.z}),
                                box({a.x, b.y, a.z}, {b.x, b.y + t, b.z})};
  if (!is_open) boxes.push_back(box({a.x - t, a.y - t, b.z}, {b.x + t, b.y + t, b.z + t}));
  return boxes;
}

TriangleMesh tank_mesh(const UprightBox& inside, double thickness, bool is_open) {
  TriangleMesh mesh = box_mesh(outside_of(inside, thickness, is_open));
  TriangleMesh cavity = box_mesh(inside);
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  if (!is_open) {
    append(mesh, cavity);
    return mesh;
  }
  // The tops of both are left out; a rim joins their edges.
  const auto is_top = [](const Triangle& t) { return t[0] >= 4 && t[1] >= 4 && t[2] >= 4; };
  std::erase_if(mesh.triangles, is_top);
  std::erase_if(cavity.triangles, is_top);
  append(mesh, cavity);
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t outer = 4 + k, next = 4 + (k + 1) % 4;
    mesh.triangles.push_back({outer, next, next + 8});
    mesh.triangles.push_back({outer, next + 8, outer + 8});
  }
  return mesh;
}

}  // namespace sabo
