#pragma once

#include <vector>

#include "terrain/body.hpp"
#include "terrain/ground_columns.hpp"

namespace sabo {

/// Particles that fill the solid of a body down to its reach below the surface, about a spacing
/// (m) apart: the first layer lies half a spacing behind the surface, and edges and corners are as
/// full as faces. Masses add up to the density (kg/m3) times the volume of what they fill.
///
/// Boxes have a lattice along their own sides, its outer layers at half a spacing exactly and the
/// ones between them evenly spaced. Other meshes have particles by shell_points(). Throws CaseError
/// when the body is too thin for a single one, or would have far too many.
std::vector<GroundPoint> body_points(const Body& body, double spacing, double density);

}  // namespace sabo
