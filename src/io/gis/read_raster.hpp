#pragma once

#include <filesystem>
#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// What a raster beside the DEM must agree with.
struct RasterPlace {
  std::string key;             ///< of the case, which names the file: faults are reported there
  std::string dem_crs;         ///< WKT of the DEM's CRS, "" for a DEM without one
  bool assume_metres = false;  ///< a raster without a CRS is taken to be in that of the DEM
};

// Both read a raster on any north-up grid in the CRS of the DEM; NaN where it has no data. They
// throw CaseError at the key, also for another CRS.

/// Release thickness, m; refuses negative ones and a raster without a positive one.
Raster read_thickness(const std::filesystem::path& file, const RasterPlace& place);

/// Elevation, m; refuses absurd ones and a raster without data.
Raster read_elevation(const std::filesystem::path& file, const RasterPlace& place);

}  // namespace sabo
