#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/colour.hpp"
#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// What stands behind a number of a classified raster.
struct RasterClass {
  int number = 1;  ///< 1 to 255
  std::string label = {};
  Colour colour{};
};

/// Writes whole numbers from 1 to 255 as a GeoTIFF of bytes with a colour table; NaN becomes 0, the
/// nodata value. The labels stand as metadata (CLASS_1, ...) in the file and as names of categories
/// in an .aux.xml beside it, where GDAL and QGIS look for them. Throws RunError, also for a value
/// that is no such number.
void write_class_raster(const std::filesystem::path& file, const Raster& classes,
                        const std::vector<RasterClass>& names, const std::string& crs_wkt,
                        const std::string& description);

/// Cells of one number that touch along edges, as a polygon.
struct ClassPolygon {
  int number = 0;
  Polygon polygon;
};

/// Outlines of whole numbers along the edges of cells, each connected area by itself; NaN belongs
/// to none. Throws RunError.
std::vector<ClassPolygon> polygons_of(const Raster& classes);

}  // namespace sabo
