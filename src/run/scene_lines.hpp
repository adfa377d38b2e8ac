#pragma once

#include <string>
#include <vector>

#include "case/line_source.hpp"
#include "run/scene.hpp"
#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// A point of the CRS in the solver frame.
inline Vec3d in_frame(const Frame& frame, const Vec3d& x) { return x - frame.origin(); }

/// From coordinates of the CRS.
inline void to_frame(const Frame& frame, Grid& grid) {
  grid.west -= frame.origin_x;
  grid.north -= frame.origin_y;
}

/// Back to those coordinates, in which files are.
inline Raster in_crs(Raster raster, const Frame& frame) {
  raster.grid.west += frame.origin_x;
  raster.grid.north += frame.origin_y;
  return raster;
}

inline void to_frame(const Frame& frame, Polygon& polygon) {
  for (std::vector<Vec3d>& ring : polygon.rings)
    for (Vec3d& vertex : ring) vertex = in_frame(frame, vertex);
}

/// The one line that a key of the case names, in the solver frame. Throws CaseError at the key,
/// also when no part of it lies on the ground of the scene.
Polyline read_line(const LineSource& source, const std::string& key, const Scene& scene);

/// A polygon given by its coordinates. Throws CaseError for one without a clear inside.
Polygon drawn_polygon(const LineSource& source, const std::string& key);

/// The polygons that a key of the case names, in the solver frame. Throws CaseError at the key.
std::vector<Polygon> read_area(const LineSource& source, const std::string& key,
                               const Frame& frame);

}  // namespace sabo
