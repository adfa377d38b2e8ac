#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/gis/class_map.hpp"
#include "io/output/colour_scale.hpp"

namespace sabo {

// Layer styles of QGIS 3 (.qml) for rasters of one band, in the colours of our pictures. A file
// beside a raster with its name and .qml is taken by QGIS when the raster is opened. `label` is the
// quantity with its unit, e.g. "depth [m]"; it stands in the first entry of the legend.

/// Colours of flow_colour from 0 to `top` (> 0); values up to `threshold` are transparent.
std::string qgis_flow_style(std::string_view label, double threshold, double top);

/// The classes of a stepped scale.
std::string qgis_step_style(std::string_view label, std::span<const ColourStep> steps);

/// Whole numbers with a label and a colour each.
std::string qgis_class_style(const std::vector<RasterClass>& classes);

/// Hillshade with light from the north-west, 45 degrees up.
std::string qgis_ground_style();

}  // namespace sabo
