#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.hpp"

#include "terrain/polyline.hpp"

namespace sabo {

/// Why a polygon has no clear inside, e.g. "Self-intersection[3 4]" in its own coordinates; empty
/// for a sound one (the rules of OGC Simple Features, by GEOS).
std::string fault_of(const Polygon& polygon);

/// Whether a line meets itself elsewhere than where it closes.
bool meets_itself(const Polyline& line);

/// Area that two sound polygons have in common, m2; 0 where they only touch.
double shared_area(const Polygon& a, const Polygon& b);

/// Two of some polygons that have more ground in common than outlines round by.
struct Overlap {
  std::size_t first = 0, second = 0;  ///< their indices, ascending
  double area = 0;                    ///< m2
};
std::vector<Overlap> overlaps(const std::vector<Polygon>& polygons);

/// Its corners: without the vertices at which a ring goes straight on.
Polygon corners_of(const Polygon& polygon);

/// The solid over a sound polygon between two elevations (m), closed and facing outwards; holes
/// are shafts through it. It has no other vertices than those of corners_of(). Empty when GEOS
/// cannot cut it into triangles.
TriangleMesh prism_mesh(const Polygon& polygon, double bottom, double top);

}  // namespace sabo
