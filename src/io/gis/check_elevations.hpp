#pragma once

#include <string>

#include "io/gis/raster_file.hpp"

namespace sabo {

/// Throws CaseError at `key` when a raster of elevations (m), called `name`, has no data at all or
/// values that no ground on Earth has.
void check_elevations(const std::string& key, const std::string& name, const Raster& raster);

/// Refuses a raster whose elevations are not in metres, as its vertical CRS or its band says.
void check_elevation_unit(const RasterFile& file);

}  // namespace sabo
