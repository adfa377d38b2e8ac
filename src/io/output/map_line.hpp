#pragma once

#include <string>

#include "terrain/polyline.hpp"

namespace sabo {

/// A line drawn over a map or laid on a scene.
struct MapLine {
  enum class Kind { dam, section, path, zone, edit };
  Kind kind = Kind::path;
  std::string label = {};  ///< "" for none
  Polyline line = {};
  bool is_filled = false;  ///< on maps, as what is solid within a closed line
};

/// How a line is drawn; `dashes` is an attribute of SVG or "".
struct LineStyle {
  const char* colour;
  double width;  ///< px
  const char* dashes;
};

LineStyle style_of(MapLine::Kind kind);

}  // namespace sabo
