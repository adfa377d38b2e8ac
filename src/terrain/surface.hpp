#pragma once

#include <optional>
#include <vector>

#include "math/vec3.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Nearest place on the ground.
struct SurfacePoint {
  Vec3d point;
  Vec3d normal;         ///< unit, pointing up, of the triangle that holds the point
  double distance = 0;  ///< m, not negative
};

/// The ground as a triangulated height field: the vertices are the cell centres of the DEM, each
/// square of four is cut along its north-west to south-east diagonal. This surface is the truth;
/// boundary particles only stand for it.
class Surface {
 public:
  /// `elevation` in m; cells without data are outside the domain. Throws CaseError below
  /// 2 x 2 cells and when no cell has data.
  explicit Surface(Raster elevation);

  /// Whether (x, y) lies over a triangle whose three vertices have data.
  bool inside(double x, double y) const;

  /// Elevation, m. Outside the domain that of a cell with data nearby; always finite.
  double height(double x, double y) const;

  /// Unit normal, pointing up, of the triangle under (x, y).
  Vec3d normal(double x, double y) const;

  /// Nearest point of the triangles with data within `reach` (m); none if there is no such point.
  std::optional<SurfacePoint> nearest(const Vec3d& point, double reach) const;

  /// Elevations; cells outside the domain are NaN.
  const Raster& elevation() const { return elevation_; }

 private:
  struct Square;
  Square square_at(double x, double y) const;

  Raster elevation_;
  std::vector<double> extended_;  // every cell filled from the nearest ones with data
};

}  // namespace sabo
