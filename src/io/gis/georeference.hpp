#pragma once

#include <string>

#include <gdal_priv.h>

#include "terrain/raster.hpp"

namespace sabo {

/// Tells a dataset that is being written where its cells lie; `crs_wkt` is "" for none.
void georeference(GDALDataset& data, const Grid& grid, const std::string& crs_wkt);

}  // namespace sabo
