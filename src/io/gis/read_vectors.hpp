#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

/// All lines of a vector file in any format of OGR, in the CRS of the DEM (`dem_crs`: its WKT, ""
/// for a DEM without one, whose coordinates are then taken to be those of the file). Multi-lines
/// are split, z is kept as it is. Throws CaseError at `key`, the key of the case that names the
/// file: unreadable, no line in it, lines in more than one layer, not finite, not reprojectable.
std::vector<Polyline> read_lines(const std::filesystem::path& file, const std::string& dem_crs,
                                 const std::string& key);

/// The same for polygons; rings that cross themselves or each other are refused.
std::vector<Polygon> read_polygons(const std::filesystem::path& file, const std::string& dem_crs,
                                   const std::string& key);

}  // namespace sabo
