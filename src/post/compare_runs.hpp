#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sabo {

/// What a command of this folder made.
struct PostResult {
  std::filesystem::path index;       ///< page to open
  std::vector<std::string> summary;  ///< lines to print
};

/// Sets two finished runs side by side, for instance with and without a dam: differences b - a of
/// the maps that both have (GeoTIFF and picture), where each of them went, key quantities, peaks,
/// and the series of both in one chart. Maps of b on another grid are resampled to that of a, which
/// the page says. Writes to `output`; "" for the folder `compare` within run a. Throws CaseError.
PostResult compare_runs(const std::filesystem::path& a, const std::filesystem::path& b,
                        const std::filesystem::path& output);

}  // namespace sabo
