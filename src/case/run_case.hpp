#pragma once

#include "base/describe.hpp"

namespace sabo {

struct RunCase {
  double duration = 0;
  double output_interval = 5;
  double series_interval = 0.5;

  template <class V>
  void describe(V&& v) {
    v(Key{"duration", "s", "simulated time"}.above(0).at_most(1e7).required(), duration);
    v(Key{"output_interval", "s", "between frames"}.above(0).at_most(1e7), output_interval);
    v(Key{"series_interval", "s", "between rows of the series"}.above(0).at_most(1e7),
      series_interval);
  }
};

}  // namespace sabo
