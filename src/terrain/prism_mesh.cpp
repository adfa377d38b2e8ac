#include "terrain/prism_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/mesh_topology.hpp"
#include <geos_c.h>

namespace sabo {
namespace {

constexpr double straight = 1e-6;  // of the length of two edges: how far a vertex may lie off them

/// GEOS without its messages; each call has its own, so that calls may run side by side.
class Geos {
 public:
  struct Delete {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Delete>;

  Geos() : context_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(context_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  GEOSContextHandle_t context() const { return context_; }
  Geometry own(GEOSGeometry* geometry) const { return {geometry, Delete{context_}}; }

  /// Empty for a polygon of which a ring has fewer than three vertices.
  Geometry polygon(const Polygon& from) const {
    std::vector<GEOSGeometry*> rings;
    for (const std::vector<Vec3d>& vertices : from.rings) {
      GEOSGeometry* made = vertices.size() < 3 ? nullptr : ring(vertices);
      if (made) {
        rings.push_back(made);
        continue;
      }
      for (GEOSGeometry* other : rings) GEOSGeom_destroy_r(context_, other);
      return own(nullptr);
    }
    if (rings.empty()) return own(nullptr);
    return own(GEOSGeom_createPolygon_r(context_, rings[0], rings.data() + 1,
                                        static_cast<unsigned>(rings.size() - 1)));
  }

  Geometry line(const std::vector<Vec3d>& vertices) const {
    const auto count = static_cast<unsigned>(vertices.size());
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(context_, count, 2);
    for (unsigned k = 0; k < count; ++k)
      GEOSCoordSeq_setXY_r(context_, points, k, vertices[k].x, vertices[k].y);
    return own(GEOSGeom_createLineString_r(context_, points));
  }

 private:
  GEOSGeometry* ring(const std::vector<Vec3d>& vertices) const {
    const auto count = static_cast<unsigned>(vertices.size());
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(context_, count + 1, 2);
    for (unsigned k = 0; k <= count; ++k)
      GEOSCoordSeq_setXY_r(context_, points, k, vertices[k % count].x, vertices[k % count].y);
    return GEOSGeom_createLinearRing_r(context_, points);
  }

  GEOSContextHandle_t context_;
};

/// Without vertices at which the ring goes straight on.
std::vector<Vec3d> corners_of(const std::vector<Vec3d>& ring) {
  std::vector<Vec3d> corners;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec3d before = ring[k] - (corners.empty() ? ring.back() : corners.back());
    const Vec3d after = ring[(k + 1) % ring.size()] - ring[k];
    const double scale = std::hypot(before.x, before.y) + std::hypot(after.x, after.y);
    const bool is_straight =
        std::abs(before.x * after.y - before.y * after.x) <= straight * scale * scale &&
        before.x * after.x + before.y * after.y > 0;
    if (!is_straight) corners.push_back(ring[k]);
  }
  return corners.size() < 3 ? ring : corners;
}

/// Vertices of a prism: that of the floor at an even number, the one over it at the next.
class PrismVertices {
 public:
  PrismVertices(const Polygon& polygon, double bottom, double top) {
    for (const std::vector<Vec3d>& ring : polygon.rings) {
      for (const Vec3d& v : ring) {
        const auto number = static_cast<std::uint32_t>(list.size());
        if (!numbers_.emplace(std::pair{v.x, v.y}, number).second) continue;
        list.insert(list.end(), {{v.x, v.y, bottom}, {v.x, v.y, top}});
      }
    }
  }
  std::optional<std::uint32_t> at(double x, double y) const {
    const auto found = numbers_.find({x, y});
    if (found == numbers_.end()) return {};
    return found->second;
  }

  std::vector<Vec3d> list;

 private:
  std::map<std::pair<double, double>, std::uint32_t> numbers_;
};

void append_walls(const Polygon& polygon, const PrismVertices& vertices, TriangleMesh& mesh) {
  for (const std::vector<Vec3d>& ring : polygon.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec3d& next = ring[(k + 1) % ring.size()];
      const std::uint32_t a = *vertices.at(ring[k].x, ring[k].y), b = *vertices.at(next.x, next.y);
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
}

/// Floor and top; false if GEOS makes other triangles than between the vertices.
bool append_floors(const Polygon& polygon, const PrismVertices& vertices, TriangleMesh& mesh) {
  const Geos geos;
  const Geos::Geometry outline = geos.polygon(polygon);
  if (!outline) return false;
  const Geos::Geometry triangles =
      geos.own(GEOSConstrainedDelaunayTriangulation_r(geos.context(), outline.get()));
  if (!triangles) return false;
  const int count = GEOSGetNumGeometries_r(geos.context(), triangles.get());
  for (int t = 0; t < count; ++t) {
    const GEOSGeometry* triangle = GEOSGetGeometryN_r(geos.context(), triangles.get(), t);
    const GEOSGeometry* ring = GEOSGetExteriorRing_r(geos.context(), triangle);
    const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos.context(), ring);
    Triangle floor{};
    for (unsigned k = 0; k < 3; ++k) {
      double x = 0, y = 0;
      GEOSCoordSeq_getXY_r(geos.context(), points, k, &x, &y);
      const std::optional<std::uint32_t> vertex = vertices.at(x, y);
      if (!vertex) return false;
      floor[k] = *vertex;
    }
    mesh.triangles.push_back(floor);
    mesh.triangles.push_back({floor[0] + 1, floor[1] + 1, floor[2] + 1});
  }
  return count > 0;
}

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

Polygon corners_of(const Polygon& polygon) {
  Polygon plain;
  for (const std::vector<Vec3d>& ring : polygon.rings) plain.rings.push_back(corners_of(ring));
  return plain;
}

TriangleMesh prism_mesh(const Polygon& polygon, double bottom, double top) {
  const Polygon plain = corners_of(polygon);
  const PrismVertices vertices(plain, bottom, top);
  TriangleMesh mesh{vertices.list, {}};
  append_walls(plain, vertices, mesh);
  const bool is_floored = append_floors(plain, vertices, mesh);
  if (!is_floored || !orient_outwards(mesh).is_watertight()) return {};
  return mesh;
}

}  // namespace sabo
