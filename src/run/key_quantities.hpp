#pragma once

#include <string>
#include <vector>

#include "run/pictures.hpp"
#include "run/scene.hpp"
#include "run/series_row.hpp"

namespace sabo {

/// One number that sums up a run, for comparing it with others.
struct KeyQuantity {
  std::string name;
  std::string unit;
  double value = 0;

  std::string label() const { return name + " [" + unit + "]"; }
};

/// Front run-out at the end and its greatest speed; at each dam the arrival and the volumes; at
/// each section arrival and greatest discharge, in either direction; what left the map; area and
/// mean depth of the deposit. Speeds and discharges are means over a row of the series, arrivals
/// those of the map. An arrival that never came is left out.
std::vector<KeyQuantity> key_quantities(const RunMaps& maps, const std::vector<SeriesRow>& rows,
                                        const Scene& scene);

}  // namespace sabo
