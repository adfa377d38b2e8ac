#pragma once

#include <string>
#include <vector>

#include "analysis/resolution.hpp"
#include "analysis/rest.hpp"
#include "run/key_quantities.hpp"
#include "run/pass_account.hpp"
#include "run/simulation.hpp"
#include "run/structure_loads.hpp"

namespace sabo {

/// What is said of a run when it is over.
struct RunFacts {
  RunEnd end = RunEnd::finished;
  std::string reason;   ///< of a failure, or of an end before the case's duration
  std::string started;  ///< UTC, ISO 8601
  SolverTotals solver;
  std::vector<PassShare> passes;
  std::size_t particles = 0;           ///< released and come in
  std::size_t boundary_particles = 0;  ///< at the end
  double raster_volume = 0;            ///< sum over dep.tif, m3
  double particle_volume = 0;          ///< of the particles in the domain, m3
  double top_speed = 0;                ///< m/s
  double sound_speed = 0;              ///< greatest, m/s
  double top_mach = 0;                 ///< greatest speed over the sound speed of its time
  ResolutionGuard resolution;
  MotionState motion;              ///< at the end
  std::vector<Basin> basins;       ///< one entry per check dam
  std::vector<LoadSummary> loads;  ///< one entry per structure, then per body
  std::vector<KeyQuantity> quantities;
  std::vector<double> resumed;  ///< times at which the run was taken up again, s
  std::string branched_from;    ///< folder of the run that the state at its start is of
  double branched_at = 0;       ///< s
};

}  // namespace sabo
