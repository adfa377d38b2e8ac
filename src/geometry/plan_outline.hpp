#pragma once

#include <vector>

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// The convex outline of a mesh in plan, anticlockwise; z is 0.
std::vector<Vec3d> plan_outline(const TriangleMesh& mesh);

}  // namespace sabo
