#include "terrain/prism_mesh.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/mesh_topology.hpp"

#include "terrain/geos.hpp"

namespace sabo {
namespace {

constexpr double straight = 1e-6;  // of the length of two edges: how far a vertex may lie off them

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

}  // namespace

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
