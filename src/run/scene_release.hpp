#pragma once

#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Fills the release of a scene that has its surface, at the density of a column at rest; sets
/// release, release_volume, release_area, release_depth and release_centre. Throws CaseError.
void read_release(const Case& c, Scene& scene);

}  // namespace sabo
