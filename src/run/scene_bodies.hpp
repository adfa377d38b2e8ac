#pragma once

#include "base/faults.hpp"
#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Makes boxes and tanks, reads and closes meshes, and the solids of the scene's buildings after
/// them: sets bodies of the scene. Adds every fault.
void read_bodies(const Case& c, Scene& scene, Faults& faults);

/// What pictures show of a body: of a tank its inside without a floor that is the ground, else all
/// of its mesh. Triangles face the flow.
TriangleMesh shown_mesh(const BodyCase& c, const Body& body, const Scene& scene);

/// The same of a body of the scene by its index, which may be a building.
TriangleMesh shown_mesh(const Case& c, std::size_t index, const Scene& scene);

/// Whether that is a solid, and not a hollow that one looks into.
bool is_shown_solid(const Case& c, std::size_t index);

}  // namespace sabo
