#include "terrain/polygon_checks.hpp"

#include <algorithm>

#include "geometry/triangle_mesh.hpp"

#include "terrain/geos.hpp"

namespace sabo {
namespace {

Bounds plan_bounds(const Polygon& outline) {
  Bounds bounds{outline.rings[0][0], outline.rings[0][0]};
  for (const Vec3d& v : outline.rings[0]) {
    bounds.low = {std::min(bounds.low.x, v.x), std::min(bounds.low.y, v.y), 0};
    bounds.high = {std::max(bounds.high.x, v.x), std::max(bounds.high.y, v.y), 0};
  }
  return bounds;
}

/// Whether the rectangles around two polygons meet, which is soon told.
bool may_share(const Polygon& a, const Polygon& b) {
  const Bounds first = plan_bounds(a), second = plan_bounds(b);
  return first.low.x < second.high.x && second.low.x < first.high.x &&
         first.low.y < second.high.y && second.low.y < first.high.y;
}

}  // namespace

std::string fault_of(const Polygon& polygon) {
  const Geos geos;
  const Geos::Geometry outline = geos.polygon(polygon);
  if (!outline) return "Fewer than three points";
  if (GEOSisValid_r(geos.context(), outline.get()) == 1) return "";
  char* reason = GEOSisValidReason_r(geos.context(), outline.get());
  const std::string text = reason ? reason : "Not a polygon";
  GEOSFree_r(geos.context(), reason);
  return text;
}

bool meets_itself(const Polyline& line) {
  const Geos geos;
  const Geos::Geometry drawn = geos.line(line.vertices);
  return drawn && GEOSisSimple_r(geos.context(), drawn.get()) == 0;
}

double shared_area(const Polygon& a, const Polygon& b) {
  if (!may_share(a, b)) return 0;
  const Geos geos;
  const Geos::Geometry first = geos.polygon(a), second = geos.polygon(b);
  if (!first || !second) return 0;
  const Geos::Geometry shared =
      geos.own(GEOSIntersection_r(geos.context(), first.get(), second.get()));
  double area = 0;
  if (shared) GEOSArea_r(geos.context(), shared.get(), &area);
  return area;
}

std::vector<Overlap> overlaps(const std::vector<Polygon>& polygons) {
  constexpr double rounding = 0.01;  // of the smaller one
  std::vector<Overlap> found;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double shared = shared_area(polygons[i], polygons[j]);
      if (shared > rounding * std::min(area(polygons[i]), area(polygons[j])))
        found.push_back({j, i, shared});
    }
  }
  return found;
}

}  // namespace sabo
