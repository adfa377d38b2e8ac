#pragma once

#include "backend/model.hpp"
#include "case/case.hpp"
#include "physics/time_step.hpp"
#include "solver/fast_stepper.hpp"

namespace sabo {

/// The model of a case. `release_depth` (m) stands in for `numerics.h_max` where that is not given:
/// c0 = beta max(sqrt(g h_max), reference_speed).
FlowModel flow_model(const MaterialCase& material, const NumericsCase& numerics,
                     double release_depth);

/// Coefficients of the time step of the fast method. The sound speed of the model is its lowest.
FastRule fast_rule(const NumericsCase& numerics, const FlowModel& model);

/// Coefficients of the time step of the method of the paper.
TimeStepRule time_step_rule(const NumericsCase& numerics, const FlowModel& model);

}  // namespace sabo
