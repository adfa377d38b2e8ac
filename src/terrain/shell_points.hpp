#pragma once

#include <vector>

#include "terrain/body.hpp"
#include "terrain/ground_columns.hpp"

namespace sabo {

/// Particles in the shell of a body of any shape, from its surface down to its reach. They are the
/// centres of cells that fill the shell evenly, one per cubed spacing (m): a centroidal Voronoi
/// tessellation (Du, Faber & Gunzburger 1999) by Lloyd's iterations from a lattice, whose first
/// layer is kept half a spacing behind the surface. A mass is the density (kg/m3) times the volume
/// of its cell, counted on a lattice of a third of the spacing: plates thinner than that may be
/// missed. A body without a surface in its bounds has none.
std::vector<GroundPoint> shell_points(const Body& body, double spacing, double density);

}  // namespace sabo
