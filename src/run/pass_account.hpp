#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "backend/pass_times.hpp"
#include "io/output/index_page.hpp"

namespace sabo {

/// What one pass took of a run.
struct PassShare {
  std::string name;
  double seconds = 0;       ///< wall time
  double share = 0;         ///< of the wall time of the run
  std::uint64_t calls = 0;  ///< 0 for what is no pass
  double pair_rate = 0;     ///< pairs/s; 0 for a pass over single particles
};

/// All passes, the longest first; last "everything else" of a run of `wall` seconds: recording and
/// writing results.
std::vector<PassShare> pass_shares(const PassTimes& times, double wall);

/// A [[passes]] table of the manifest for each.
std::string passes_toml(const std::vector<PassShare>& shares);

/// The table for the page of a run.
PageTable pass_table(const std::vector<PassShare>& shares);

/// How the steps of a run went.
struct SolverTotals {
  std::size_t steps = 0;
  double simulated = 0;          ///< s
  double wall = 0;               ///< s
  std::uint64_t iterations = 0;  ///< of the viscous solve

  double mean_dt() const { return over_steps(simulated); }
  double mean_iterations() const { return over_steps(static_cast<double>(iterations)); }
  double steps_per_second() const { return wall > 0 ? static_cast<double>(steps) / wall : 0; }

 private:
  double over_steps(double sum) const { return steps > 0 ? sum / static_cast<double>(steps) : 0; }
};

/// The [solver] table of the manifest.
std::string solver_toml(const SolverTotals& totals);

/// "33462 steps of 8.97 ms in the mean, 1474 steps/s, 1.6 iterations of the viscous solve a step";
/// without the last part where nothing was solved for.
std::string solver_text(const SolverTotals& totals);

}  // namespace sabo
