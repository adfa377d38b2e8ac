#pragma once

#include <filesystem>
#include <string>

#include "terrain/raster.hpp"

namespace sabo {

/// Writes an ESRI ASCII grid with nine digits, which give every value of a map's GeoTIFF back, NaN
/// as -9999; a .prj beside it holds the coordinate system (WKT of ESRI), if there is one. Cells
/// that are not square get the lines `dx` and `dy`, which GDAL and QGIS read. Throws RunError.
void write_ascii_grid(const std::filesystem::path& file, const Raster& raster,
                      const std::string& crs_wkt);

}  // namespace sabo
