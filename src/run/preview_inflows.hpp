#pragma once

#include "case/case.hpp"
#include "run/preview_lines.hpp"
#include "run/scene.hpp"

namespace sabo {

/// What comes in through each inflow, and whether particles resolve it.
void tell_inflows(Preview& preview, const Case& c, const Scene& scene);

}  // namespace sabo
