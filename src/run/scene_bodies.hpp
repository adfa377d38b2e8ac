#pragma once

#include "base/faults.hpp"
#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Makes boxes and tanks, reads and closes meshes: sets bodies of the scene. Adds every fault.
void read_bodies(const Case& c, Scene& scene, Faults& faults);

/// What pictures show of a body: of a tank its inside without a floor that is the ground, else all
/// of its mesh. Triangles face the flow.
TriangleMesh shown_mesh(const BodyCase& c, const Body& body, const Scene& scene);

}  // namespace sabo
