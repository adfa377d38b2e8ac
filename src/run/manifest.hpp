#pragma once

#include <string>
#include <vector>

#include "run/run_facts.hpp"
#include "run/run_folder.hpp"

namespace sabo {

/// Version of the layout of a run folder.
inline constexpr int run_folder_version = 1;

/// Writes manifest.toml, with the checksums of the inputs.
void write_manifest(const RunFacts& facts, const Case& c, const Scene& scene,
                    const std::vector<SeriesRow>& rows, const RunFolder& folder);

/// The table of the manifest that says which inputs a case has: each file with its checksum.
std::string input_checksums(const Case& c);

/// UTC now, ISO 8601.
std::string utc_now();

}  // namespace sabo
