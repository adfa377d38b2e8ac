#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// Where an opening begins above the ground; neither key: at the ground.
struct SillCase {
  std::optional<double> height;
  std::optional<double> elevation;

  template <class V>
  void describe(V&& v) {
    v(Key{"sill", "m",
          "lower edge of the opening above the lowest ground under it; default: it is open from "
          "the ground"}
          .at_least(0)
          .at_most(1e4),
      height);
    v(Key{"sill_elevation", "m", "the same as an elevation"}.at_least(-1e4).at_most(1e4),
      elevation);
  }
};

/// A rectangle of the face of a dam that is open: a slit, a culvert, or one more notch.
struct SlitCase {
  double centre = 0;
  double width = 0;
  SillCase sill;
  std::optional<double> height;

  template <class V>
  void describe(V&& v) {
    v(Key{"centre", "m", "of the opening, as distance along the line"}
          .at_least(0)
          .at_most(1e6)
          .required(),
      centre);
    v(Key{"width", "m", "of the opening along the line"}.above(0).at_most(1e5).required(), width);
    sill.describe(v);
    v(Key{"height", "m", "of the opening above its sill; default: it is open up to the crest"}
          .above(0)
          .at_most(1e4),
      height);
  }
};

/// A stretch of a dam that is a row of posts with gaps between them.
struct GridCase {
  double from = 0;
  double to = 0;
  double gap = 0;
  double post_width = 0;
  std::optional<double> post_depth;
  SillCase sill;
  std::optional<double> beam_gap;
  std::optional<double> beam_height;

  template <class V>
  void describe(V&& v) {
    v(Key{"from", "m", "where the stretch begins, as distance along the line"}
          .at_least(0)
          .at_most(1e6)
          .required(),
      from);
    v(Key{"to", "m", "where it ends"}.above(0).at_most(1e6).required(), to);
    v(Key{"gap", "m",
          "clear width between posts; as many gaps as fit stand in the middle of the stretch, the "
          "rest of it stays wall"}
          .above(0)
          .at_most(1e4)
          .required(),
      gap);
    v(Key{"post_width", "m", "of a post along the line"}.above(0).at_most(1e4).required(),
      post_width);
    v(Key{"post_depth", "m", "of posts and beams along the flow; default: the thickness of the dam"}
          .above(0)
          .at_most(1e4),
      post_depth);
    sill.describe(v);
    v(Key{"beam_gap", "m", "clear height below and between crossbeams; default: there are none"}
          .above(0)
          .at_most(1e4),
      beam_gap);
    v(Key{"beam_height", "m", "of a crossbeam; needed with beam_gap"}.above(0).at_most(1e4),
      beam_height);
  }
};

enum class StructureKind { check_dam, deflection_wall, building };
template <>
struct Words<StructureKind> {
  static constexpr std::array<std::string_view, 3> list{"check_dam", "deflection_wall", "building"};
};

struct StructureCase {
  std::string name;
  StructureKind kind = StructureKind::check_dam;
  LineSource line;
  LineSource polygon;
  std::optional<double> crest;
  std::optional<double> height;
  std::string height_attribute;
  std::optional<double> thickness;
  std::optional<NotchCase> notch;
  std::vector<SlitCase> slits;
  std::vector<GridCase> grids;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs; several buildings of one file get a number behind it"},
      name);
    v(Key{"kind", "",
          "check_dam: a wall from the ground up to its crest; deflection_wall: a wall whose top "
          "follows the ground; building: solids with a level top over polygons"},
      kind);
    v(Key{"line", "",
          "check_dam, deflection_wall: its axis, a vector file or coordinates; z, if any, is its "
          "crest"},
      line);
    v(Key{"polygon", "",
          "building: the outline, a vector file with one or several or coordinates of one; holes "
          "are courtyards"},
      polygon);
    v(Key{"crest", "m", "check_dam, deflection_wall: elevation of the crest"}
          .at_least(-1e4)
          .at_most(1e4),
      crest);
    v(Key{"height", "m",
          "check_dam: of the crest above the lowest ground along the line; deflection_wall: of "
          "its top above the ground everywhere; building: of its top above the lowest ground of "
          "its outline"}
          .above(0)
          .at_most(1e4),
      height);
    v(Key{"height_attribute", "",
          "building: attribute of the polygons in the file that holds the height of each, m"},
      height_attribute);
    v(Key{"thickness", "m", "check_dam, deflection_wall: along the flow; required there"}
          .above(0)
          .at_most(1e4),
      thickness);
    v(Key{"notch", "", "check_dam: spillway cut into the crest"}, notch);
    v.tables("slit", "check_dam: vertical slits, or other rectangles that are open through the dam",
             slits);
    v.tables("grid", "check_dam: stretches that are rows of posts, as in a grid dam", grids);
  }
};

}  // namespace sabo
