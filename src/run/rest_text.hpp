#pragma once

#include <string>

#include "analysis/rest.hpp"
#include "case/run_case.hpp"

namespace sabo {

/// The limits that a case sets.
RestLimits rest_limits(const RunCase& run);

/// How much of the flow moves, e.g. "3.1 % of the volume faster than 0.01 m/s, ...".
std::string motion_text(const MotionState& motion, const RunCase& run);

/// Why a run has ended at rest, with the limits of the case.
std::string rest_reason(const MotionState& motion, const RunCase& run);

}  // namespace sabo
