#include "io/case_file/check_observed.hpp"

#include "io/case_file/check_parts.hpp"

namespace sabo {

void check_observed(const ObservedCase& observed, Faults& faults) {
  check_polygon(observed.outline, "observed.outline", faults);
  check_polygon(observed.within, "observed.within", faults);
  const bool by_raster = !observed.depth_raster.empty() || faults.has("observed.depth_raster");
  const bool by_outline = observed.outline.given() || faults.has("observed.outline");
  if (by_raster && by_outline) {
    faults.add("observed", "has a depth_raster and an outline", "give one of the two");
  } else if (observed.within.given() && !by_raster && !by_outline) {
    faults.add("observed.within", "has nothing to compare in it",
               "give depth_raster or outline too");
  }
  check_names(observed.arrivals, "observed.arrival", faults);
}

}  // namespace sabo
