#include "run/view_solids.hpp"

#include <algorithm>
#include <cmath>

#include "run/scene_bodies.hpp"

namespace sabo {
namespace {

constexpr double side_width = 1e-3;  // m along the line, of an upright side of a notch

/// One cut across a wall.
struct Cut {
  Vec3d left;   ///< upper edge to the left of the axis
  Vec3d right;  ///< upper edge to its right
  double foot = 0;
};

/// Where the wall is cut: evenly, and on both sides of every corner of its notch.
std::vector<double> stations(const CheckDam& dam, double step) {
  const double whole = length(dam.axis);
  const double parts = std::clamp(std::ceil(whole / step), 8.0, 800.0);
  std::vector<double> at;
  for (int i = 0; i <= static_cast<int>(parts); ++i) at.push_back(whole * i / parts);
  if (dam.notch) {
    const double sill = dam.notch->width / 2;
    const double rim = sill + dam.notch->depth * dam.notch->side_slope;
    for (const double side : {-1.0, 1.0})
      for (const double aside : {sill - side_width, sill + side_width, rim})
        at.push_back(std::clamp(dam.notch->centre + side * aside, 0.0, whole));
  }
  std::ranges::sort(at);
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

Cut cut_at(const CheckDam& dam, const Surface& surface, double station) {
  const Vec3d middle = point_at(dam.axis, station);
  const Vec3d along = direction_at(dam.axis, station);
  const Vec3d aside = dam.thickness / 2 * Vec3d{-along.y, along.x, 0};
  const Vec3d edge{middle.x, middle.y, dam.top(station)};
  Cut cut{edge + aside, edge - aside};
  const double ground =
      std::min({surface.height(middle.x, middle.y), surface.height(cut.left.x, cut.left.y),
                surface.height(cut.right.x, cut.right.y)});
  // Some way into the ground, of which the view may show every other cell alone.
  const Grid& grid = surface.elevation().grid;
  cut.foot = std::min(ground, edge.z) - 2 * std::max({grid.dx, grid.dy, 0.5});
  return cut;
}

void add_face(TriangleMesh& mesh, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

Vec3d down_to(Vec3d edge, double foot) {
  edge.z = foot;
  return edge;
}

}  // namespace

TriangleMesh dam_mesh(const CheckDam& dam, const Surface& surface) {
  std::vector<Cut> cuts;
  const double step = std::max(dam.thickness / 2, 1e-3);
  for (const double station : stations(dam, step)) cuts.push_back(cut_at(dam, surface, station));
  TriangleMesh mesh;
  const auto left_foot = [](const Cut& cut) { return down_to(cut.left, cut.foot); };
  const auto right_foot = [](const Cut& cut) { return down_to(cut.right, cut.foot); };
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    const Cut &a = cuts[k - 1], &b = cuts[k];
    add_face(mesh, a.right, b.right, b.left, a.left);
    add_face(mesh, left_foot(a), a.left, b.left, left_foot(b));
    add_face(mesh, right_foot(a), right_foot(b), b.right, a.right);
  }
  const Cut &first = cuts.front(), &last = cuts.back();
  add_face(mesh, left_foot(first), right_foot(first), first.right, first.left);
  add_face(mesh, right_foot(last), left_foot(last), last.left, last.right);
  return mesh;
}

std::vector<ViewSolid> view_solids(const Case& c, const Scene& scene) {
  std::vector<ViewSolid> solids;
  for (const CheckDam& dam : scene.dams)
    solids.push_back({dam.name, dam_mesh(dam, *scene.surface)});
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    solids.push_back({scene.bodies[b].name(), shown_mesh(c.bodies[b], scene.bodies[b], scene)});
  return solids;
}

}  // namespace sabo
