#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

/// Stations of many points on one long path, without projecting every point on every piece of it.
class StationIndex {
 public:
  /// Throws CaseError unless the path has two different vertices.
  explicit StationIndex(const Polyline& path);

  /// Mean station of the foremost `share` of the mass, m; the last point counts with the part of
  /// its mass that is needed. As many masses as points; points are finite. Nothing without mass.
  std::optional<double> foremost(const std::vector<Vec3d>& points,
                                 const std::vector<double>& masses, double share) const;

 private:
  /// Pieces that can be the nearest one to a point of some disc.
  struct Candidates {
    std::size_t first = 0;
    std::size_t last = 0;
    double lowest = 0;  // bounds of the stations of the disc's points
    double highest = 0;
  };

  Candidates candidates(double x, double y, double radius) const;
  Polyline stretch(const Candidates& near) const;
  double station(const Vec3d& point, const Candidates& near, const Polyline& stretch) const;

  Polyline path_;                 // no two neighbouring vertices are equal in plan
  std::vector<double> stations_;  // of the vertices
};

}  // namespace sabo
