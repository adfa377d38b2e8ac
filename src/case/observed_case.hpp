#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/describe.hpp"
#include "case/line_source.hpp"

namespace sabo {

/// A place that the flow reached at a known time.
struct ObservedArrivalCase {
  std::string name;
  std::array<double, 2> place{};
  double time = 0;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"place", "m", "[x, y] in the coordinates of the DEM"}
          .at_least(-1e9)
          .at_most(1e9)
          .required(),
      place);
    v(Key{"time", "s", "after the start of the run at which the flow was there"}
          .at_least(0)
          .at_most(1e7)
          .required(),
      time);
  }
};

enum class ComparedMap { automatic, deposit, peak_depth };
template <>
struct Words<ComparedMap> {
  static constexpr std::array<std::string_view, 3> list{"auto", "deposit", "peak_depth"};
};

/// What is known of the event from a survey; `sabo compare` sets the run beside it.
struct ObservedCase {
  std::filesystem::path depth_raster;
  LineSource outline;
  LineSource within;
  ComparedMap map = ComparedMap::automatic;
  double wet_depth = 0.1;
  std::string source = "survey";
  std::vector<ObservedArrivalCase> arrivals;

  bool has_footprint() const { return !depth_raster.empty() || outline.given(); }

  template <class V>
  void describe(V&& v) {
    v(Key{"depth_raster", "", "depth of the deposit, m; cells without data count as dry"},
      depth_raster);
    v(Key{"outline", "", "area that was affected: a vector file or coordinates"}, outline);
    v(Key{"within", "",
          "area that was surveyed, outside of which nothing is compared: a vector file or "
          "coordinates"},
      within);
    v(Key{"map", "",
          "of the run that is compared; auto: the deposit with a raster, the greatest depth with "
          "an outline"},
      map);
    v(Key{"wet_depth", "m", "above which a cell counts as reached, in the run and in the raster"}
          .at_least(0)
          .at_most(100),
      wet_depth);
    v(Key{"source", "", "where this is from"}, source);
    v.tables("arrival", "times at which the flow reached places", arrivals);
  }
};

}  // namespace sabo
