#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "terrain/raster.hpp"

namespace sabo {

struct Dem {
  Raster raster;        ///< elevations, m, in CRS coordinates
  std::string crs_wkt;  ///< "" for a DEM without one
  std::filesystem::path path;
};

/// Reads an elevation raster in any format of GDAL. `crop` keeps the cells that touch the window
/// [west, south, east, north] in CRS coordinates; only they are read. Throws CaseError at
/// terrain.dem or terrain.crop: unreadable, not one band, rotated, less than 2 x 2 or too many
/// cells, no CRS (unless `assume_metres`), not projected in metres, no data, absurd elevations.
Dem read_dem(const std::filesystem::path& file, bool assume_metres,
             const std::optional<std::array<double, 4>>& crop = {});

}  // namespace sabo
