#pragma once

#include <vector>

#include "case/case.hpp"
#include "io/output/view_scene.hpp"
#include "run/scene.hpp"

namespace sabo {

/// The wall of a check dam with its notch, from below the ground to its crest. Faces look outwards;
/// it has no bottom.
TriangleMesh dam_mesh(const CheckDam& dam, const Surface& surface);

/// Dams and bodies as the 3D view shows them.
std::vector<ViewSolid> view_solids(const Case& c, const Scene& scene);

}  // namespace sabo
