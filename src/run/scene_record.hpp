#pragma once

#include <string>

#include "case/case.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Writes what is known before the first step, so that it is there however the run ends: case.toml,
/// maps/plan.geojson (path, structures, bodies, inflows, sections, zones), maps/ground.tif
/// (elevation) and maps/rel.tif (depth of the release).
/// Throws RunError.
void write_scene_record(const Case& c, const Scene& scene, const RunFolder& folder);

/// Tables of the manifest: [terrain] with what was done to the DEM, [[edit]], and [release].
std::string scene_toml(const Case& c, const Scene& scene);

}  // namespace sabo
