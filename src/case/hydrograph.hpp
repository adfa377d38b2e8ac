#pragma once

#include <cstddef>
#include <vector>

#include "base/describe.hpp"

namespace sabo {

/// Discharge against time, and optionally speed: straight between its rows, no discharge outside.
struct Hydrograph {
  std::vector<double> time;       ///< s, increasing
  std::vector<double> discharge;  ///< m3/s, not negative; as many
  std::vector<double> speed;      ///< m/s; as many, or none. Above 0 where there is discharge

  double discharge_at(double t) const;  ///< m3/s
  double volume_until(double t) const;  ///< m3, the exact integral from the first row
  double volume() const;                ///< m3, of all of it

  /// Speed given for a time, m/s: straight between the rows that have discharge, as at the nearest
  /// of them outside. Needs speeds and a discharge somewhere.
  double speed_at(double t) const;

  /// Row of the greatest discharge, the first of several.
  std::size_t peak() const;
  /// From here on nothing comes any more, s.
  double end() const;
};

/// A triangular surge of a case; the peak is from start to end, the end after the start.
struct Surge {
  double start = 0;
  double peak_time = 0;
  double end = 0;
  double peak_discharge = 0;

  template <class V>
  void describe(V&& v) {
    v(Key{"start", "s", "when it begins"}.at_least(0).at_most(1e7), start);
    v(Key{"peak_time", "s", "when it is greatest, from its start to its end"}
          .at_least(0)
          .at_most(1e7)
          .required(),
      peak_time);
    v(Key{"end", "s", "when it is over"}.above(0).at_most(1e7).required(), end);
    v(Key{"peak_discharge", "m3/s", "its greatest discharge, of solids and water together"}
          .above(0)
          .at_most(1e6)
          .required(),
      peak_discharge);
  }
};

/// The hydrograph of surges, which may overlap: their discharges add up.
Hydrograph hydrograph_of(const std::vector<Surge>& surges);

}  // namespace sabo
