#pragma once

#include <optional>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Earliest arrival (s) on the cells within `half_width` (m) of a line, in plan; none where the
/// flow never came. `arrival` is a map of arrival times, NaN where the ground stayed dry.
std::optional<double> first_arrival(const Raster& arrival, const Polyline& line, double half_width);

}  // namespace sabo
