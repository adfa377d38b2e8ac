#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/describe.hpp"

namespace sabo {

enum class BodyKind { box, tank, mesh };
template <>
struct Words<BodyKind> {
  static constexpr std::array<std::string_view, 3> list{"box", "tank", "mesh"};
};

enum class BodyFrame { crs, local };
template <>
struct Words<BodyFrame> {
  static constexpr std::array<std::string_view, 2> list{"crs", "local"};
};

enum class BodyFlow { outside, inside };
template <>
struct Words<BodyFlow> {
  static constexpr std::array<std::string_view, 2> list{"outside", "inside"};
};

/// A solid of any shape that stands in the flow or holds it.
struct BodyCase {
  std::string name;
  BodyKind kind = BodyKind::box;
  std::optional<std::array<double, 3>> min;
  std::optional<std::array<double, 3>> max;
  double rotation = 0;
  bool open_top = true;
  std::filesystem::path file;
  BodyFrame frame = BodyFrame::crs;
  std::optional<std::array<double, 3>> at;
  double scale = 1;
  BodyFlow flow = BodyFlow::outside;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"kind", "",
          "box: a solid box; tank: the inside of a box with a floor and walls around it; mesh: a "
          "closed surface of triangles from a file"}
          .required(),
      kind);
    v(Key{"min", "m", "box, tank: the lowest corner [x, y, z]; of a tank that of its inside"}
          .at_least(-1e8)
          .at_most(1e8),
      min);
    v(Key{"max", "m", "box, tank: the corner across [x, y, z]"}.at_least(-1e8).at_most(1e8), max);
    v(Key{"rotation", "deg", "box, tank: turn about its vertical axis, anticlockwise from above"}
          .at_least(-360)
          .at_most(360),
      rotation);
    v(Key{"open_top", "", "tank: has no lid"}, open_top);
    v(Key{"file", "", "mesh: an STL (ASCII or binary) or OBJ file"}, file);
    v(Key{"frame", "",
          "mesh: crs: its coordinates are those of the terrain, z up; local: they count from the "
          "point at"},
      frame);
    v(Key{"at", "m", "mesh: added to its coordinates [x, y, z]; needed with frame = \"local\""}
          .at_least(-1e8)
          .at_most(1e8),
      at);
    v(Key{"scale", "", "mesh: its coordinates are multiplied by this, e.g. 0.001 for millimetres"}
          .above(0)
          .at_most(1e6),
      scale);
    v(Key{"flow", "",
          "mesh: the side where the flow is; outside: the mesh is a solid; inside: it is the wall "
          "of a hollow. Which way its triangles face does not matter"},
      flow);
  }
};

}  // namespace sabo
