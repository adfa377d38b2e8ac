#pragma once

#include "base/faults.hpp"
#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Makes the inflows of a scene, and sets the centre of its release to the place of the largest.
/// Adds every fault: a line outside of the DEM or one that turns back, a section that does not hold
/// the highest level between its ends, solids in the way. Returns whether there was none.
bool read_inflows(const Case& c, Scene& scene, Faults& faults);

/// Throws CaseError where the release or another inflow lies where an inflow comes in.
void check_inflow_places(const Scene& scene);

}  // namespace sabo
