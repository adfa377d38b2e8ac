#include "run/scene_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/read_vectors.hpp"
#include "terrain/polygon_checks.hpp"

namespace sabo {
namespace {

std::vector<Vec3d> points_of(const LineSource& source) {
  std::vector<Vec3d> points;
  for (const auto& c : source.coordinates) points.push_back({c[0], c[1], c[2]});
  return points;
}

/// Whether is_wanted(point) of some point of a line, looked at in steps of a cell.
template <class Test>
bool has_point(const Polyline& line, const Grid& grid, const Test& is_wanted) {
  constexpr double most_steps = 1e6;
  const double span = length(line);
  const double steps = std::clamp(std::ceil(span / std::min(grid.dx, grid.dy)), 1.0, most_steps);
  for (int k = 0; k <= steps; ++k)
    if (is_wanted(point_at(line, span * k / steps))) return true;
  return false;
}

void refuse_beside(const Polyline& line, const std::string& key, const Surface& surface) {
  const Grid& grid = surface.elevation().grid;
  const auto is_on_ground = [&](const Vec3d& x) { return surface.inside(x.x, x.y); };
  const auto is_on_grid = [&](const Vec3d& x) {
    return grid.has_cell(grid.column_of(x.x), grid.row_of(x.y));
  };
  if (has_point(line, grid, is_on_ground)) return;
  if (has_point(line, grid, is_on_grid))
    throw CaseError(key, "the line lies where the DEM has no data",
                    "move it, raise terrain.fill_holes, or take a DEM without the hole");
  throw CaseError(key, "the line lies beside the DEM",
                  "check its coordinates and their system, or take a larger DEM");
}

}  // namespace

Polyline read_line(const LineSource& source, const std::string& key, const Scene& scene) {
  const Frame& frame = scene.frame;
  Polyline line{points_of(source), source.has_z};
  if (!source.file.empty()) {
    std::vector<Polyline> lines = read_lines(source.file, frame.crs, key);
    if (lines.size() != 1) {
      throw CaseError(
          key, fmt::format("{} holds {} lines, one is wanted", source.file.string(), lines.size()),
          "leave one line in the file, or give coordinates");
    }
    line = std::move(lines.front());
  }
  for (Vec3d& vertex : line.vertices) vertex = in_frame(frame, vertex);
  if (meets_itself(line))
    throw CaseError(key, "the line meets itself, so that places along it have no order",
                    "draw it without loops, or as two lines");
  refuse_beside(line, key, *scene.surface);
  return line;
}

Polygon drawn_polygon(const LineSource& source, const std::string& key) {
  Polygon polygon{{points_of(source)}};
  if (const std::string fault = fault_of(polygon); !fault.empty())
    throw CaseError(key, "is no sound polygon: " + fault,
                    "give its corners in the order around it");
  return polygon;
}

std::vector<Polygon> read_area(const LineSource& source, const std::string& key,
                               const Frame& frame) {
  std::vector<Polygon> polygons = source.file.empty()
                                      ? std::vector<Polygon>{drawn_polygon(source, key)}
                                      : read_polygons(source.file, frame.crs, key);
  for (Polygon& polygon : polygons) to_frame(frame, polygon);
  return polygons;
}

}  // namespace sabo
