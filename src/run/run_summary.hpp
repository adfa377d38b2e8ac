#pragma once

#include <string>
#include <vector>

#include "io/output/index_page.hpp"
#include "run/run_facts.hpp"

namespace sabo {

/// The lines to print when a run is over.
std::vector<std::string> summary_lines(const RunFacts& facts, const Case& c, const Scene& scene,
                                       const std::vector<SeriesRow>& rows);

// What the page of the run or its manifest say as well.

/// The tables of volumes, zones and loads; none without rows.
std::vector<PageTable> result_tables(const RunFacts& facts, const Case& c, const Scene& scene,
                                     const std::vector<SeriesRow>& rows);

/// "Inflow upper end: hydrograph 231 m3, entered 231 m3 (-0.02 %)"; `rows` are not empty.
std::vector<std::string> inflow_lines(const Scene& scene, const std::vector<SeriesRow>& rows);

/// Of the whole run; `rows` are not empty.
EnergyBalance balance_of(const std::vector<SeriesRow>& rows);

/// How far the volume of the maps is from that of the particles, in percent to four digits.
double map_volume_error(const RunFacts& facts);

std::string resolution_text(const ResolutionGuard& guard);
/// "" when there is nothing to warn of.
std::string resolution_warning(const ResolutionGuard& guard);

}  // namespace sabo
