#include "io/output/scene_view.hpp"

#include <algorithm>
#include <cmath>

#include "math/angle.hpp"

namespace sabo {
namespace {

CanvasCorner corner_of(const SceneMesh& mesh, int column, int row, const CanvasView& view) {
  const SceneVertex& vertex = mesh.at(column, row);
  CanvasCorner corner = view.corner(mesh.point(column, row));
  corner.shade = vertex.shade;
  corner.value = vertex.value;
  corner.elevation = vertex.elevation;
  corner.wetness = vertex.is_wet ? 1 : 0;
  return corner;
}

// The face of the slab below the edge from one corner of the mesh to another.
void draw_cut(DepthCanvas& canvas, const CanvasView& view, const Vec3d& a, const Vec3d& b,
              double thickness) {
  const auto lower = [thickness](Vec3d point) {
    point.z -= thickness;
    return point;
  };
  const CanvasCorner above_a = view.corner(a), above_b = view.corner(b);
  const CanvasCorner below_a = view.corner(lower(a)), below_b = view.corner(lower(b));
  for (const CanvasCorner* corner : {&above_a, &above_b, &below_a, &below_b}) {
    if (!(corner->nearness > 0)) return;  // behind the camera, or no ground
  }
  canvas.draw_solid(above_a, above_b, below_b, Shown::earth);
  canvas.draw_solid(above_a, below_b, below_a, Shown::earth);
}

void draw_cuts(DepthCanvas& canvas, const SceneMesh& mesh, const CanvasView& view) {
  const int right = mesh.columns() - 1, bottom = mesh.rows() - 1;
  const double thickness =
      0.01 * std::hypot(mesh.x.back() - mesh.x.front(), mesh.y.front() - mesh.y.back());
  for (int column = 0; column < right; ++column) {
    for (const int row : {0, bottom}) {
      draw_cut(canvas, view, mesh.point(column, row), mesh.point(column + 1, row), thickness);
    }
  }
  for (int row = 0; row < bottom; ++row) {
    for (const int column : {0, right}) {
      draw_cut(canvas, view, mesh.point(column, row), mesh.point(column, row + 1), thickness);
    }
  }
}

// Pixels of a trial picture that show flow, and the share of the flow's corners that are seen.
struct Trial {
  double pixels = 0;
  double share_seen = 0;
};

Trial try_direction(const SceneMesh& mesh, const LookDirection& direction) {
  constexpr int width = 220, height = 150;
  const std::vector<Vec3d> points = points_to_show(mesh);
  const CanvasView view{camera_around(points, direction, width, height, mesh.spacing())};
  DepthCanvas canvas(width, height);
  draw_mesh(canvas, mesh, view);
  const Shown wanted = mesh.has_flow() ? Shown::flow : Shown::ground;
  Trial trial;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      trial.pixels += canvas.at(column, row).shown == wanted ? 1 : 0;
    }
  }
  for (const Vec3d& point : points) {
    const CanvasCorner p = view.corner(point);
    trial.share_seen += canvas.shows(p.x, p.y, p.nearness) ? 1 : 0;
  }
  trial.share_seen /= static_cast<double>(points.size());
  return trial;
}

double azimuth_to_highest(const SceneMesh& mesh) {
  const std::vector<Vec3d> points = points_to_show(mesh);
  const auto [low, high] =
      std::ranges::minmax_element(points, [](const Vec3d& a, const Vec3d& b) { return a.z < b.z; });
  return std::atan2(high->x - low->x, high->y - low->y) / degree;
}

}  // namespace

std::vector<Vec3d> points_to_show(const SceneMesh& mesh) {
  const bool has_flow = mesh.has_flow();
  std::vector<Vec3d> points;
  for (int row = 0; row < mesh.rows(); ++row) {
    for (int column = 0; column < mesh.columns(); ++column) {
      const SceneVertex& vertex = mesh.at(column, row);
      if (std::isnan(vertex.z) || (has_flow && !vertex.is_wet)) continue;
      points.push_back(mesh.point(column, row));
    }
  }
  if (points.empty()) {  // nothing but holes: the corners of the mesh at its base
    points = {{mesh.x.front(), mesh.y.front(), mesh.base},
              {mesh.x.back(), mesh.y.back(), mesh.base}};
  }
  return points;
}

CanvasCorner CanvasView::corner(const Vec3d& point) const {
  const Projected p = camera.project(point);
  return {.x = p.x * scale, .y = (p.y - top) * scale, .nearness = 1 / p.distance};
}

void draw_mesh(DepthCanvas& canvas, const SceneMesh& mesh, const CanvasView& view) {
  std::vector<CanvasCorner> upper(mesh.columns()), lower(mesh.columns());
  const auto fill = [&](int row, std::vector<CanvasCorner>& corners) {
    for (int column = 0; column < mesh.columns(); ++column) {
      corners[column] = corner_of(mesh, column, row, view);
    }
  };
  // A triangle that reaches behind the camera or has a corner without ground is left out.
  const auto draw = [&canvas](const CanvasCorner& a, const CanvasCorner& b, const CanvasCorner& c) {
    if (a.nearness > 0 && b.nearness > 0 && c.nearness > 0) canvas.draw_ground(a, b, c);
  };
  fill(0, lower);
  for (int row = 1; row < mesh.rows(); ++row) {
    std::swap(upper, lower);
    fill(row, lower);
    for (int column = 1; column < mesh.columns(); ++column) {
      // Cut as Surface cuts its squares, from north-west to south-east.
      draw(upper[column - 1], lower[column - 1], lower[column]);
      draw(upper[column - 1], lower[column], upper[column]);
    }
  }
  draw_cuts(canvas, mesh, view);
}

LookDirection choose_direction(const SceneMesh& mesh, const LookWish& wish) {
  std::vector<double> azimuths, downs{35, 45, 55, 65};
  if (wish.azimuth) azimuths = {*wish.azimuth};
  if (wish.down) downs = {*wish.down};
  if (azimuths.empty()) {
    const double along = wish.up_valley ? *wish.up_valley : azimuth_to_highest(mesh);
    for (const double turn : {0, 25, -25, 45, -45, 60, -60}) {
      azimuths.push_back(std::fmod(along + turn + 720, 360));
    }
  }
  LookDirection best;
  for (const double down : downs) {
    Trial best_trial{-1, 0};
    for (const double azimuth : azimuths) {
      const Trial trial = try_direction(mesh, {azimuth, down});
      if (trial.pixels <= best_trial.pixels) continue;
      best_trial = trial;
      best = {azimuth, down};
    }
    if (best_trial.share_seen >= 0.9) break;
  }
  return best;
}

}  // namespace sabo
