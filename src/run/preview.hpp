#pragma once

#include <string>

#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// What `sabo check` says of a sound case: terrain, release, structures, particles, time step; and
/// how long its run will take, if `time` says it.
std::string preview_text(const Case& c, const Scene& scene, const std::string& time = "");

}  // namespace sabo
