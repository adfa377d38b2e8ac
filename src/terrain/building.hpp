#pragma once

#include <string>

#include "terrain/body.hpp"
#include "terrain/polyline.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// A solid with a level top over a polygon.
struct Building {
  std::string name;
  std::string group;  ///< of the structure that it is one of; the same as its name if it is alone
  Polygon outline;    ///< solver frame
  double bottom = 0;  ///< elevation of the lowest ground of its outline, m
  double top = 0;     ///< elevation, m
};

/// Lowest ground within a polygon and along its rings, m.
double lowest_ground(const Surface& surface, const Polygon& polygon);

/// Its solid; outlines that are rectangles to a twentieth of the spacing (m) become boxes, whose
/// particles stand in rows. `reach` (m) is that of Body. Throws CaseError
/// when its outline cannot be cut into triangles.
Body building_body(const Building& building, double reach, double spacing);

}  // namespace sabo
