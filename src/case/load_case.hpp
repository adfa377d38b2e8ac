#pragma once

#include "base/describe.hpp"

namespace sabo {

/// How the forces on structures and bodies are read.
struct LoadCase {
  double filter = 0.2;
  double alpha = 1;

  template <class V>
  void describe(V&& v) {
    v(Key{"filter", "s", "peak forces are the greatest of means over this time"}.above(0).at_most(
          1e4),
      filter);
    v(Key{"alpha", "",
          "of the design formula alpha density depth speed^2, which stands beside the forces"}
          .above(0)
          .at_most(100),
      alpha);
  }
};

}  // namespace sabo
