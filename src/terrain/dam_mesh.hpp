#pragma once

#include "geometry/triangle_mesh.hpp"

#include "terrain/check_dam.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// The solid parts of a dam between its openings as closed blocks that face outwards, side by side
/// and one on the other: for pictures and files. What stands on the ground reaches `embedment` (m)
/// below the lowest ground at its corners. The axis is mitred at its bends. Blocks with a corner
/// outside the surface's domain are left out.
TriangleMesh dam_mesh(const CheckDam& dam, const Surface& surface, double embedment);

}  // namespace sabo
