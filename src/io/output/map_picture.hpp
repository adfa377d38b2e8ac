#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/output/colour_scale.hpp"
#include "io/output/map_line.hpp"
#include "io/output/relief.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// A map of one quantity over the relief. All coordinates are in one frame.
struct MapPicture {
  std::string title = {};
  std::string note = {};           ///< small, under the title; "" for none
  std::string quantity = {};       ///< with its unit, e.g. "deposit depth [m]"
  double threshold = 0;            ///< smaller values are left out
  std::optional<double> top = {};  ///< value of the darkest colour, else from the data
  MapView view = {};
  std::vector<MapLine> lines = {};
  std::vector<ColourStep> steps = {};       ///< classes in place of the continuous colours
  std::string contours = "contours every";  ///< before their step in m
  bool has_coordinates = false;             ///< along the frame
  double widest = 1100, tallest = 900;      ///< of the map, px
  double sharpness = 2;                     ///< most pixels for one px of the page
  std::string id = {};                      ///< told apart from other maps in one page by it
};

/// The cells with a value above the threshold plus a margin of 8 % of the longer side (at least 10
/// cells), inside the grid; the whole grid when there are none.
MapView view_around(const Raster& values, double threshold);

/// The picture as an SVG file: the raster as an embedded PNG, everything else as lines and text.
/// Throws RunError.
std::string map_svg(const MapPicture& map, const Raster& elevation, const Raster& values);

}  // namespace sabo
