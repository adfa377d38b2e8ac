#pragma once

#include "io/output/depth_canvas.hpp"
#include "io/output/png.hpp"

namespace sabo {

struct SceneColours {
  double top = 1;       ///< value of the darkest colour
  double contour = 10;  ///< step of the contour lines of the ground, m
};

/// A picture of half the canvas's size, each pixel the mean of four samples: grey ground with
/// contour lines, flow in the colours of flow_colour, walls in dark red, with lines along edges.
Image shaded(const DepthCanvas& canvas, const SceneColours& colours);

}  // namespace sabo
