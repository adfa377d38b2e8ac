#pragma once

#include <string>
#include <vector>

#include "analysis/resolution.hpp"
#include "analysis/rest.hpp"
#include "io/output/index_page.hpp"
#include "run/key_quantities.hpp"
#include "run/pass_account.hpp"
#include "run/recorder.hpp"
#include "run/run_folder.hpp"
#include "run/simulation.hpp"

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

/// Version of the layout of a run folder.
inline constexpr int run_folder_version = 1;

/// Writes manifest.toml and the resolved case.toml with the checksums of its inputs.
void write_manifest(const RunFacts& facts, const Case& c, const Scene& scene,
                    const std::vector<SeriesRow>& rows, const RunFolder& folder);

/// The table of the manifest that says which inputs a case has: each file with its checksum.
std::string input_checksums(const Case& c);

/// The lines to print when a run is over.
std::vector<std::string> summary_lines(const RunFacts& facts, const Case& c, const Scene& scene,
                                       const std::vector<SeriesRow>& rows);

/// The page of the run.
IndexPage index_page(const RunFacts& facts, const Case& c, const Scene& scene,
                     const std::vector<SeriesRow>& rows, std::vector<PagePicture> pictures);

/// UTC now, ISO 8601.
std::string utc_now();

}  // namespace sabo
