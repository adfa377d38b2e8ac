#pragma once

#include <memory>
#include <vector>

#include <geos_c.h>

#include "terrain/polyline.hpp"

namespace sabo {

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

}  // namespace sabo
