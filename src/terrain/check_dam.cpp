#include "terrain/check_dam.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

double CheckDam::top(double station) const {
  const double within = std::clamp(station, 0.0, length(axis));
  return (axis.has_z ? point_at(axis, within).z : crest) - notch_depth(station);
}

double CheckDam::notch_depth(double station) const {
  if (!notch) return 0;
  const double beyond_sill = std::abs(station - notch->centre) - notch->width / 2;
  if (beyond_sill <= 0) return notch->depth;
  if (notch->side_slope <= 0) return 0;
  return std::max(0.0, notch->depth - beyond_sill / notch->side_slope);
}

bool CheckDam::contains(const Vec3d& point) const {
  const LinePlace place = project(axis, point.x, point.y);
  return std::abs(place.offset) <= thickness / 2 && place.station >= 0 &&
         place.station <= length(axis) && point.z < top(place.station);
}

}  // namespace sabo
