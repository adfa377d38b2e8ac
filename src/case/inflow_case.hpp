#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/describe.hpp"
#include "case/hydrograph.hpp"
#include "case/line_source.hpp"

namespace sabo {

enum class InflowSide { downslope, left, right };
template <>
struct Words<InflowSide> {
  static constexpr std::array<std::string_view, 3> list{"downslope", "left", "right"};
};

/// A discharge that comes in through a line.
struct InflowCase {
  std::string name;
  LineSource line;
  InflowSide flows = InflowSide::downslope;
  std::filesystem::path hydrograph;
  std::vector<Surge> surges;
  std::optional<double> speed;
  double froude = 1;

  template <class V>
  void describe(V&& v) {
    v(Key{"name", "", "used in the outputs"}, name);
    v(Key{"line", "",
          "where it comes in, from bank to bank: a vector file or coordinates; it flows across the "
          "straight line between its ends"}
          .required(),
      line);
    v(Key{"flows", "",
          "to which side: downslope; left, right: looking from the line's first vertex to its "
          "last"},
      flows);
    v(Key{"hydrograph", "",
          "CSV file with the columns time [s], discharge [m3/s] and, if known, speed [m/s]; "
          "straight between its rows, nothing outside"},
      hydrograph);
    v.tables("surge", "triangles instead of a file; where they overlap they add up", surges);
    v(Key{"speed", "m/s", "along the bed, instead of froude"}.above(0).at_most(100), speed);
    v(Key{"froude", "",
          "Froude number, from which depth and speed follow where no speed is given; 1 is critical "
          "flow"}
          .at_least(0.1)
          .at_most(10),
      froude);
  }
};

}  // namespace sabo
