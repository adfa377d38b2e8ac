#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "base/describe.hpp"
#include "case/line_source.hpp"

namespace sabo {

// What is measured, and what it is compared with.

struct SectionCase {
  std::string name;
  LineSource line;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"line", "",
          "section for discharge: a vector file or coordinates. Positive from left to right "
          "looking "
          "from its first vertex to its last: draw it from the right bank to the left one"}
          .required(),
      line);
  }
};

/// Places whose time series are written.
struct GaugeCase {
  std::string name;
  std::optional<std::array<double, 2>> place;
  std::filesystem::path file;
  std::optional<double> elevation;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs; points of a file are numbered behind it"}, name);
    v(Key{"place", "m", "[x, y] of the gauge"}.at_least(-1e8).at_most(1e8), place);
    v(Key{"file", "", "vector file of points, each a gauge"}, file);
    v(Key{"elevation", "m", "of the pressure that is measured; else that at the ground"}
          .at_least(-1e4)
          .at_most(1e4),
      elevation);
  }
};

struct ZoneCase {
  std::string name;
  LineSource polygon;
  std::optional<double> observed;
  std::string source = "observed";

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"polygon", "", "area whose depth is measured: a vector file or coordinates"}.required(),
      polygon);
    v(Key{"observed", "m", "mean depth to compare with that over the wet cells"}
          .at_least(0)
          .at_most(1e4),
      observed);
    v(Key{"source", "", "where the observed depth is from, e.g. a survey"}, source);
  }
};

struct PathCase {
  LineSource line;

  template <class V>
  void describe(V&& v) {
    v(Key{"line", "",
          "line along the valley for the front; without it, steepest descent from the release, or "
          "else from the largest inflow, and on level ground the axis along which there is most "
          "room"},
      line);
  }
};

/// Volumes known from elsewhere, printed beside those of the run.
struct ReferenceCase {
  std::string name;
  std::optional<double> released;
  std::optional<double> trapped;
  std::optional<double> beyond;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "source of the volumes, e.g. a survey"}.required(), name);
    v(Key{"released", "m3", "volume that started to move"}.at_least(0).at_most(1e12), released);
    v(Key{"trapped", "m3", "volume held above the dam"}.at_least(0).at_most(1e12), trapped);
    v(Key{"beyond", "m3", "volume that passed the dam"}.at_least(0).at_most(1e12), beyond);
  }
};

}  // namespace sabo
