#pragma once

#include "backend/model.hpp"
#include "case/case.hpp"
#include "physics/time_step.hpp"

namespace sabo {

/// The model of a case. `release_depth` (m) stands in for `numerics.h_max` where that is not given:
/// c0 = beta max(sqrt(g h_max), reference_speed).
FlowModel flow_model(const MaterialCase& material, const NumericsCase& numerics,
                     double release_depth);

/// Coefficients of the time step that belong to the model.
TimeStepRule time_step_rule(const NumericsCase& numerics, const FlowModel& model);

}  // namespace sabo
