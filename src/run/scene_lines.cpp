#include "run/scene_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/read_vectors.hpp"
#include "terrain/prism_mesh.hpp"

namespace sabo {
namespace {

std::vector<Vec3d> points_of(const LineSource& source) {
  std::vector<Vec3d> points;
  for (const auto& c : source.coordinates) points.push_back({c[0], c[1], c[2]});
  return points;
}

/// Whether some of it lies on the ground; looked at in steps of a cell.
bool touches(const Surface& surface, const Polyline& line) {
  constexpr double most_steps = 1e6;
  const Grid& grid = surface.elevation().grid;
  const double span = length(line);
  const double steps = std::clamp(std::ceil(span / std::min(grid.dx, grid.dy)), 1.0, most_steps);
  for (int k = 0; k <= steps; ++k) {
    const Vec3d at = point_at(line, span * k / steps);
    if (surface.inside(at.x, at.y)) return true;
  }
  return false;
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
  for (Vec3d& vertex : line.vertices) vertex = moved(frame, vertex);
  if (meets_itself(line))
    throw CaseError(key, "the line meets itself, so that places along it have no order",
                    "draw it without loops, or as two lines");
  if (!touches(*scene.surface, line))
    throw CaseError(key, "the line lies beside the DEM",
                    "check its coordinates and their system, or take a larger DEM");
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
  for (Polygon& polygon : polygons) move(frame, polygon);
  return polygons;
}

}  // namespace sabo
