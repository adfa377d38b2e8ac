#pragma once

#include <vector>

#include "case/case.hpp"
#include "io/output/view_scene.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Structures and bodies as the 3D view shows them.
std::vector<ViewSolid> view_solids(const Case& c, const Scene& scene);

}  // namespace sabo
