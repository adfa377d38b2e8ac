#pragma once

#include <filesystem>
#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// Reads a raster of release thickness, m, on any north-up grid in the CRS of the DEM; NaN where it
/// has no data. `dem_crs` is the WKT of the DEM's CRS, "" for a DEM without one; `assume_metres`
/// takes a raster without a CRS as being in that of the DEM. Throws CaseError at
/// release.thickness_raster, also for another CRS and for negative thickness.
Raster read_thickness(const std::filesystem::path& file, const std::string& dem_crs,
                      bool assume_metres);

}  // namespace sabo
