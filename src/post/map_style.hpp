#pragma once

#include "post/finished_run.hpp"

#include "io/gis/class_map.hpp"
#include "io/output/map_style.hpp"

namespace sabo {

/// Also in QGIS: that of the run's own pictures; of a map that has none, from what its file says of
/// itself.
MapStyle style_of(const RunMap& map, double wet_depth);

/// Steps of a picture for a map of classes, in the order of their numbers.
std::vector<ColourStep> class_steps(const std::vector<RasterClass>& classes);

/// The greatest value of a map; 0 without any above it.
double greatest_value(const Raster& raster);

}  // namespace sabo
