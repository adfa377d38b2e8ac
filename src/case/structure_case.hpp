#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/describe.hpp"
#include "case/line_source.hpp"

namespace sabo {

struct NotchCase {
  double centre = 0;
  double width = 0;
  double depth = 0;
  double side_slope = 0;

  template <class V>
  void describe(V&& v) {
    v(Key{"centre", "m", "of the notch, as distance along the line"}
          .at_least(0)
          .at_most(1e6)
          .required(),
      centre);
    v(Key{"width", "m", "of the notch at its sill"}.above(0).at_most(1e5).required(), width);
    v(Key{"depth", "m", "of the sill below the crest"}.above(0).at_most(1e4).required(), depth);
    v(Key{"side_slope", "", "horizontal run of the notch's sides for 1 m of rise"}
          .at_least(0)
          .at_most(100),
      side_slope);
  }
};

enum class StructureKind { check_dam };
template <>
struct Words<StructureKind> {
  static constexpr std::array<std::string_view, 1> list{"check_dam"};
};

struct StructureCase {
  std::string name;
  StructureKind kind = StructureKind::check_dam;
  LineSource line;
  std::optional<double> crest;
  std::optional<double> height;
  double thickness = 0;
  std::optional<NotchCase> notch;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"kind", "", "check_dam: a wall from the ground up to its crest"}, kind);
    v(Key{"line", "", "axis of the dam: a vector file or coordinates; z, if any, is its crest"}
          .required(),
      line);
    v(Key{"crest", "m", "elevation of the crest"}.at_least(-1e4).at_most(1e4), crest);
    v(Key{"height", "m", "of the crest above the lowest ground along the line"}.above(0).at_most(
          1e4),
      height);
    v(Key{"thickness", "m", "along the flow"}.above(0).at_most(1e4).required(), thickness);
    v(Key{"notch", "", "spillway cut into the crest"}, notch);
  }
};

}  // namespace sabo
