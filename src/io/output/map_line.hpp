#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/describe.hpp"
#include "terrain/polyline.hpp"

namespace sabo {

/// A line drawn over a map or laid on a scene.
struct MapLine {
  enum class Kind { dam, section, path, zone, edit, inflow };
  Kind kind = Kind::path;
  std::string label = {};  ///< drawn beside it; "" for none
  Polyline line = {};
  bool is_filled = false;  ///< on maps, as what is solid within a closed line
  std::string name = {};   ///< of what it is a part of; "" where the label says that

  const std::string& name_or_label() const { return name.empty() ? label : name; }
};

/// As `maps/plan.geojson` has them.
template <>
struct Words<MapLine::Kind> {
  static constexpr std::array<std::string_view, 6> list{"structure", "section", "path",
                                                        "zone",      "edit",    "inflow"};
};

/// How a line is drawn; `dashes` is an attribute of SVG or "".
struct LineStyle {
  const char* colour;
  double width;  ///< px
  const char* dashes;
};

LineStyle style_of(MapLine::Kind kind);

}  // namespace sabo
