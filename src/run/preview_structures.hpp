#pragma once

#include "case/case.hpp"
#include "run/preview_lines.hpp"
#include "run/scene.hpp"
#include "solver/flow_model.hpp"

namespace sabo {

/// Dams with their openings, walls, buildings and bodies, and what the particles are too coarse
/// for.
void tell_structures(Preview& preview, const Case& c, const Scene& scene, const FlowModel& model);

}  // namespace sabo
