#pragma once

#include <string>

#include <gdal_priv.h>

#include "terrain/raster.hpp"

namespace sabo {

/// What a written raster has in cells without data.
inline constexpr float no_data_value = -9999;

/// Tells a dataset that is being written where its cells lie; `crs_wkt` is "" for none.
void georeference(GDALDataset& data, const Grid& grid, const std::string& crs_wkt);

}  // namespace sabo
