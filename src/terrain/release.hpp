#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "particles/particles.hpp"
#include "terrain/body.hpp"
#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// The mass that starts to move, as a thickness on the ground.
struct ReleaseShape {
  std::function<double(double x, double y)> thickness;  ///< vertical, m; 0 outside
  double west = 0, south = 0, east = 0, north = 0;      ///< rectangle that holds it
  double volume = 0;                                    ///< m3
  double area = 0;                                      ///< in plan, m2
};

/// A polygon and the thickness over it, m.
struct ThickPolygon {
  Polygon polygon;
  double thickness = 0;
};

/// Polygons that do not overlap.
ReleaseShape release_of(std::vector<ThickPolygon> polygons);

/// Thickness (m) cell by cell; none where the raster has no data or is negative.
ReleaseShape release_of(Raster thickness);

/// The same shape with its thickness taken as normal to the ground: vertical thickness is that over
/// the z of the ground's unit normal. The volume is integrated with steps of a quarter `spacing`.
/// The surface must outlive the shape.
ReleaseShape made_vertical(const ReleaseShape& shape, const Surface& surface, double spacing);

/// The same shape with its thickness scaled so that it holds `volume` (m3).
ReleaseShape scaled_to(const ReleaseShape& shape, double volume);

struct ReleaseSettings {
  double spacing = 1;     ///< particle spacing, m
  double density = 1000;  ///< reference density, kg/m3
  Frame frame;            ///< of the surface, so that errors name CRS coordinates
};

/// Fills a release with particles at rest: on each column of the horizontal lattice (centres at
/// odd multiples of half a spacing) round(thickness / spacing) of them, which share it evenly. What
/// is thinner than half a spacing goes, from column to column, into the next particle that has half
/// a spacing of it. Masses go with the height that each stands for and sum up to volume x density;
/// ids count from 0. Throws CaseError where the release lies outside the DEM, when it has no
/// particle, or too many.
Particles released(const Surface& surface, const ReleaseShape& shape,
                   const ReleaseSettings& settings);

/// Particles for a list of points, each the centre of `point_volume` (m3). If the spacing is the
/// side of that cube, to 1e-6 m, they are the particles; otherwise the sites above the ground of a
/// cubic lattice that lie in any of the cubes are. All masses are equal and sum up to volume x
/// density; ids and errors as above.
Particles released(const Surface& surface, const std::vector<Vec3d>& points, double point_volume,
                   const ReleaseSettings& settings);

/// Columns that stand side by side in a box, about a spacing apart.
struct BoxColumns {
  std::int64_t count_x = 1, count_y = 1;
  double dx = 0, dy = 0;  ///< sides of each in plan, m
};
BoxColumns box_columns(const Bounds& box, double spacing);

/// Fills a box: columns in step with its sides, from its floor or the ground under it to its level
/// top, the outermost half a step from the sides. Columns stand about a spacing apart so that they
/// fit, and so do the particles of each. What would stand in a body, or nearer to it than a quarter
/// of a spacing, is left out. Masses go with the height of the steps and add up to the volume that
/// is filled times the density; ids and errors as above.
Particles released_box(const Surface& surface, const Bounds& box, const std::vector<Body>& bodies,
                       const ReleaseSettings& settings);

}  // namespace sabo
