#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "post/compare_runs.hpp"

namespace sabo {

struct HazardOptions {
  std::vector<std::filesystem::path> runs;
  std::string rules = "swiss";         ///< a name of known_hazard_rules() or a file
  std::vector<double> return_periods;  ///< years, of each run; empty for none
  std::filesystem::path output;        ///< "" for the folder `hazard` within the first run
};

/// The text of rules: those of the program or a file. Throws CaseError for a name that is neither.
std::string hazard_rules_of(const std::string& name);

/// Classifies the maps of finished runs by rules, takes the worst of each cell over the runs and,
/// with return periods, the level of hazard by the matrix of the rules. Writes a classified GeoTIFF
/// with its colours, outlines (GeoPackage), a picture, areas and the rules themselves. Maps of
/// later runs on another grid are resampled to that of the first. Throws CaseError.
PostResult hazard_maps(const HazardOptions& options);

}  // namespace sabo
