#pragma once

#include <string>
#include <vector>

#include "io/output/colour_scale.hpp"

namespace sabo {

/// How a map of a run is drawn.
struct MapStyle {
  std::string title;
  std::string quantity;                ///< with its unit, e.g. "depth [m]"
  double threshold = 0;                ///< smaller values are left out
  std::vector<ColourStep> steps = {};  ///< classes in place of continuous colours
};

}  // namespace sabo
