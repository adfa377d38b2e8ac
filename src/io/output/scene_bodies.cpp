#include "io/output/scene_bodies.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace sabo {
namespace {

constexpr std::size_t most_places = 200;  // tried for a label

Vec3d drawn(Vec3d point, const SceneMesh& mesh) {
  point.z = mesh.drawn(point.z);
  return point;
}

/// The part of a polygon where `inside` (m, linear in the place) is not negative.
template <class Inside>
std::vector<Vec3d> cut(const std::vector<Vec3d>& polygon, const Inside& inside) {
  std::vector<Vec3d> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

}  // namespace

// Sutherland & Hodgman (1974).
TriangleMesh within(const MapView& view, const TriangleMesh& mesh) {
  TriangleMesh result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::vector<Vec3d> part{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    part = cut(part, [&](const Vec3d& p) { return p.x - view.west; });
    part = cut(part, [&](const Vec3d& p) { return view.east - p.x; });
    part = cut(part, [&](const Vec3d& p) { return p.y - view.south; });
    part = cut(part, [&](const Vec3d& p) { return view.north - p.y; });
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), part.begin(), part.end());
    for (std::uint32_t k = 2; k < part.size(); ++k)
      result.triangles.push_back({first, first + k - 1, first + k});
  }
  return result;
}

void draw_body(DepthCanvas& canvas, const SceneBody& body, const SceneMesh& mesh,
               const CanvasView& view, const Vec3d& to_light) {
  for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
    std::array<CanvasCorner, 3> corners;
    bool is_ahead = true;
    for (int k = 0; k < 3; ++k) {
      corners[k] = view.corner(drawn(body.mesh.corner(t, k), mesh));
      is_ahead = is_ahead && corners[k].nearness > 0;
    }
    const auto& [a, b, c] = corners;
    // y goes down on the canvas.
    const bool faces_camera = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0;
    if (!is_ahead || !faces_camera) continue;
    const Vec3d normal = normalised(area_vector(body.mesh, t));
    const auto shade = static_cast<float>(0.5 + 0.5 * dot(normal, to_light));
    for (CanvasCorner& corner : corners) corner.shade = shade;
    canvas.draw_solid(a, b, c, Shown::wall);
  }
}

void label_body(const ScenePage& page, const SceneBody& body, SceneLabels& labels) {
  if (body.label.empty()) return;
  std::vector<Vec3d> places = body.mesh.vertices;
  std::ranges::stable_sort(places, std::ranges::greater{}, &Vec3d::z);
  places.resize(std::min(places.size(), most_places));
  std::vector<PagePoint> points;
  for (const Vec3d& place : places) points.push_back(page_point(page, drawn(place, page.mesh)));
  labels.add(body.label, wall_label_colour, points);
}

}  // namespace sabo
