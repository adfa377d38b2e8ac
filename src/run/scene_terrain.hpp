#pragma once

#include "base/faults.hpp"
#include "case/case.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Reads the DEM or makes the plane, fills holes, makes the edits and, for a release by a pair of
/// DEMs, digs its hollow: sets frame, surface, holes, notes, edits and lost of the scene. Adds
/// every fault; the scene has a surface only when the DEM itself could be read.
void read_terrain(const Case& c, Scene& scene, Faults& faults);

}  // namespace sabo
