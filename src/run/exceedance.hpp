#pragma once

#include <filesystem>
#include <vector>

#include "case/case.hpp"
#include "io/output/index_page.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// The share of maps in which a cell holds more than `limit`; NaN where no map has a value. The
/// maps have one grid.
Raster share_above(const std::vector<Raster>& maps, double limit);

/// For each depth (m) the share of the runs whose greatest depth was above it: writes
/// maps/exceedance_DEPTHm.tif and a picture of each below `folder`; returns the pictures. Throws
/// RunError when the maps of the runs cannot be read or are not on one grid.
std::vector<PagePicture> write_exceedance(const std::vector<std::filesystem::path>& runs,
                                          const std::vector<double>& depths, const Case& c,
                                          const std::filesystem::path& folder);

}  // namespace sabo
