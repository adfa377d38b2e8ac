#pragma once

#include "geometry/triangle_mesh.hpp"

#include "terrain/polyline.hpp"

namespace sabo {

/// The corners of a polygon: without the vertices at which a ring goes straight on.
Polygon corners_of(const Polygon& polygon);

/// The solid over a sound polygon between two elevations (m), closed and facing outwards; holes
/// are shafts through it. It has no other vertices than those of corners_of(). Empty when GEOS
/// cannot cut it into triangles.
TriangleMesh prism_mesh(const Polygon& polygon, double bottom, double top);

}  // namespace sabo
