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

}  // namespace

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
