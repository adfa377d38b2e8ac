#pragma once

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// Solid angle of a triangle seen from a point, over 4 pi; positive when the point sees its back
/// (van Oosterom & Strackee 1983). 0 for a point in its plane.
double solid_angle_share(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& from);

/// How often a mesh that faces outwards goes around a point: 1 inside, 0 outside, 1/2 on a face
/// (Jacobson et al. 2013). Sum over all triangles.
double winding_number(const TriangleMesh& mesh, const Vec3d& point);

}  // namespace sabo
