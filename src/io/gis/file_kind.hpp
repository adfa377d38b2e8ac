#pragma once

#include <filesystem>

namespace sabo {

enum class GisFileKind { unknown, raster, vectors };

/// What GDAL takes a file for; unknown when it is not there or no format of GDAL. A GeoPackage with
/// both is a raster.
GisFileKind kind_of_gis_file(const std::filesystem::path& file);

}  // namespace sabo
