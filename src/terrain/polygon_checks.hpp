#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

/// Why a polygon has no clear inside, e.g. "Self-intersection[3 4]" in its own coordinates; empty
/// for a sound one (the rules of OGC Simple Features, by GEOS).
std::string fault_of(const Polygon& polygon);

/// Whether a line meets itself elsewhere than where it closes.
bool meets_itself(const Polyline& line);

/// Area that two sound polygons have in common, m2; 0 where they only touch.
double shared_area(const Polygon& a, const Polygon& b);

/// Two of some polygons that have more in common than 1 % of the smaller one; less is rounding of
/// outlines.
struct Overlap {
  std::size_t first = 0, second = 0;  ///< their indices, ascending
  double area = 0;                    ///< m2
};
/// All such pairs of sound polygons.
std::vector<Overlap> overlaps(const std::vector<Polygon>& polygons);

}  // namespace sabo
