#pragma once

#include <string>
#include <vector>

#include "post/finished_run.hpp"

#include "io/output/colour_scale.hpp"

namespace sabo {

/// How a map of a run is drawn, here and in QGIS.
struct MapStyle {
  std::string title;
  std::string quantity;           ///< with its unit, e.g. "depth [m]"
  double threshold = 0;           ///< smaller values are left out
  std::vector<ColourStep> steps;  ///< classes in place of continuous colours
};

/// That of the run's own pictures; of a map that has none, from what its file says of itself.
MapStyle style_of(const RunMap& map, double wet_depth);

/// The greatest value of a map; 0 without any above it.
double greatest_value(const Raster& raster);

}  // namespace sabo
