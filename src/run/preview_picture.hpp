#pragma once

#include <string>

#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Map of what a case holds before anything moves, as an SVG file: hillshade, depth of the release,
/// dams, sections, zones, path, edits of the terrain.
std::string preview_svg(const Case& c, const Scene& scene);

}  // namespace sabo
