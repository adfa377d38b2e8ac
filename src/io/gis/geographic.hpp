#pragma once

#include <optional>
#include <string>

namespace sabo {

/// A place on the WGS 84 ellipsoid.
struct Geographic {
  double latitude = 0;   ///< deg, positive to the north
  double longitude = 0;  ///< deg, positive to the east
};

/// Where a point of a coordinate system (its WKT) lies; nothing without a system that PROJ can
/// place.
std::optional<Geographic> geographic(const std::string& crs_wkt, double x, double y);

}  // namespace sabo
