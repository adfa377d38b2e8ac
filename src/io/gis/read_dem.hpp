#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/raster.hpp"

namespace sabo {

/// Which elevations are wanted, and how.
struct DemRequest {
  std::filesystem::path file = {};  ///< raster of GDAL; FG-GML as .xml, folder or .zip
  bool assume_metres = false;       ///< take a raster without coordinate system to be in metres
  /// Keeps the cells that touch [west, south, east, north], in the coordinates of the result.
  std::optional<std::array<double, 4>> crop = {};
  /// Projected in metres, any text that GDAL understands, e.g. "EPSG:6691"; "" keeps that of the
  /// file. A raster without one is taken to be in it.
  std::string crs = {};
  double cell_size = 0;  ///< of square cells, m; 0 keeps those of the file, or about those
};

struct Dem {
  Raster raster;                        ///< elevations, m, in CRS coordinates
  std::string crs_wkt;                  ///< "" for a DEM without one
  std::vector<std::string> notes = {};  ///< what was done to it, a sentence part each
};

/// Reads elevations. Tiles of the Japanese base map (FG-GML, read_fg_gml.hpp) are in degrees and go
/// to `crs`, else to the UTM zone of their middle, in cells of 1, 5 or 10 m; other rasters stay as
/// they are unless `crs` or `cell_size` ask for something else (warp.hpp). Throws CaseError at
/// terrain.dem, terrain.crop, terrain.crs or terrain.cell_size: unreadable, not one band, rotated,
/// less than 2 x 2 or too many cells, no CRS (unless `assume_metres`), in degrees or other units
/// without `crs`, elevations not in metres, no data, absurd elevations.
Dem read_dem(const DemRequest& request);

}  // namespace sabo
