#pragma once

#include <span>

#include "io/output/colour_scale.hpp"
#include "io/output/png.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Part of the map to draw, in the coordinates of the rasters.
struct MapView {
  double west = 0;
  double south = 0;
  double east = 1;
  double north = 1;
};

struct Relief {
  const Raster& elevation;
  const Raster& values;
  double threshold = 0;                    ///< smaller values are left out
  double top = 1;                          ///< value of the darkest colour
  double contour = 10;                     ///< step of the contour lines, m
  std::span<const ColourStep> steps = {};  ///< classes in place of the continuous colours
};

/// Draws the values in the colours of flow_colour from 0 to the top, or cell by cell in those of
/// their classes, with an outline, over a grey hillshade (light from the north-west) with contour
/// lines, on `width` x `height` pixels.
Image draw_relief(const Relief& relief, const MapView& view, int width, int height);

}  // namespace sabo
