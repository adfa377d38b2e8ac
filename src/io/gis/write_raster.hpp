#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// What a raster file says about itself.
struct RasterInfo {
  std::string crs_wkt = {};      ///< "" for none
  std::string description = {};  ///< of the band, e.g. "peak flow depth"
  std::string unit = {};         ///< e.g. "m"
  std::map<std::string, std::string> metadata = {};
};

/// Writes a GeoTIFF: float32, deflate, NaN as nodata -9999. The file appears under its name only
/// when it is complete. Throws RunError with the reason, also for an infinite value.
void write_raster(const std::filesystem::path& file, const Raster& raster, const RasterInfo& info);

}  // namespace sabo
