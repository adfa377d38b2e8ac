#pragma once

#include <string>
#include <vector>

#include "post/finished_run.hpp"

#include "io/output/map_line.hpp"
#include "run/scene.hpp"

namespace sabo {

/// What stands on the map of a run, in the coordinates of its CRS.
struct RunPlan {
  std::vector<MapLine> lines;       ///< of all that has a place, as in the pictures of a run
  std::vector<MapLine> structures;  ///< whole dams and outlines of bodies, all with their names
  std::vector<MapLine> inflows;
  std::vector<NamedZone> zones;
  std::vector<NamedSection> sections;
  Polyline path;        ///< along which the front was measured; empty if it is not known
  std::string problem;  ///< why nothing of this is known; "" when it is
};

/// Makes the scene of the run's case again, which takes its input files.
RunPlan plan_of(const FinishedRun& run);

}  // namespace sabo
