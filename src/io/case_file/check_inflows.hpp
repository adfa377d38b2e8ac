#pragma once

#include <vector>

#include "base/faults.hpp"
#include "case/inflow_case.hpp"

namespace sabo {

/// Adds a fault for an inflow without a hydrograph or with two, and for surges that are none.
void check_inflows(const std::vector<InflowCase>& inflows, Faults& faults);

}  // namespace sabo
