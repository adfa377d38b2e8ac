#pragma once

#include <cstddef>
#include <vector>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Indices of the cells whose centres lie in any of the polygons, in rising order, each once.
std::vector<std::size_t> cells_within(const Grid& grid, const std::vector<Polygon>& polygons);

}  // namespace sabo
