#include "io/output/scene_bodies.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace sabo {
namespace {

constexpr std::size_t most_places = 200;  // tried for a label
constexpr double same_place = 1e-6;       // m

Vec3d drawn(Vec3d point, const SceneMesh& mesh) {
  point.z = mesh.drawn(point.z);
  return point;
}

/// An edge of a cut face.
struct CutEdge {
  Vec3d from;
  Vec3d to;
};

/// The part of a triangle where `inside` (m, linear in the place) is not negative, and the edge
/// along which the rest was cut off, as the face that closes the cut goes along it.
template <class Inside>
std::vector<Vec3d> cut(const std::array<Vec3d, 3>& triangle, const Inside& inside,
                       std::vector<CutEdge>& edges) {
  std::vector<Vec3d> kept;
  CutEdge edge;
  bool is_cut = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d &a = triangle[k], &b = triangle[(k + 1) % 3];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) == (at_b >= 0)) continue;
    kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    (at_a >= 0 ? edge.to : edge.from) = kept.back();
    is_cut = true;
  }
  if (is_cut && norm(edge.to - edge.from) > same_place) edges.push_back(edge);
  return kept;
}

void append_fan(TriangleMesh& mesh, const std::vector<Vec3d>& polygon) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), polygon.begin(), polygon.end());
  for (std::uint32_t k = 2; k < polygon.size(); ++k)
    mesh.triangles.push_back({first, first + k - 1, first + k});
}

/// Closes a cut, one loop of edges after the other.
void append_faces(TriangleMesh& mesh, std::vector<CutEdge> edges) {
  while (!edges.empty()) {
    std::vector<Vec3d> loop{edges.back().from};
    Vec3d end = edges.back().to;
    edges.pop_back();
    while (norm(end - loop.front()) > same_place) {
      const auto next = std::ranges::find_if(
          edges, [&](const CutEdge& edge) { return norm(edge.from - end) <= same_place; });
      if (next == edges.end()) break;
      loop.push_back(end);
      end = next->to;
      *next = edges.back();
      edges.pop_back();
    }
    append_fan(mesh, loop);
  }
}

// Sutherland & Hodgman (1974).
template <class Inside>
TriangleMesh cut(const SceneBody& body, const TriangleMesh& mesh, const Inside& inside) {
  TriangleMesh result;
  std::vector<CutEdge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    append_fan(result,
               cut({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, inside, edges));
  if (body.is_solid) append_faces(result, std::move(edges));
  return result;
}

}  // namespace

SceneBody within(const MapView& view, const SceneBody& body) {
  TriangleMesh mesh = cut(body, body.mesh, [&](const Vec3d& p) { return p.x - view.west; });
  mesh = cut(body, mesh, [&](const Vec3d& p) { return view.east - p.x; });
  mesh = cut(body, mesh, [&](const Vec3d& p) { return p.y - view.south; });
  mesh = cut(body, mesh, [&](const Vec3d& p) { return view.north - p.y; });
  return {body.label, std::move(mesh), body.is_solid};
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
    // Sides a little darker than the top, so that the edge between them shows in any light.
    const double shade = (normal.z > 0 ? 1 : 0.75) * (0.5 + 0.5 * dot(normal, to_light));
    for (CanvasCorner& corner : corners) corner.shade = static_cast<float>(shade);
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
