#pragma once

#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// Throws CaseError at `key` when a raster of elevations (m), called `name`, has no data at all or
/// values that no ground on Earth has.
void check_elevations(const std::string& key, const std::string& name, const Raster& raster);

}  // namespace sabo
