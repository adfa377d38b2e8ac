#pragma once

#include <cstddef>
#include <limits>

#include "backend/backend.hpp"
#include "physics/time_step.hpp"
#include "solver/domain.hpp"

namespace sabo {

/// What a step was like.
struct StepReport {
  double dt = 0;      ///< s
  FlowExtremes flow;  ///< at the start of the step
};

/// The paper's time step: predictor-corrector with the rates at the middle of the step.
class Stepper {
 public:
  /// `domain` may be null: then the boundary is what the caller put there.
  Stepper(Backend& backend, const TimeStepRule& rule, Domain* domain);

  /// Largest deviation of rho / rho0 from 1 that a run survives.
  static constexpr double density_tolerance = 0.1;

  /// One step, no longer than `longest` (s). Throws RunError when the state is no longer finite or
  /// a density has left its range.
  StepReport step(double longest = std::numeric_limits<double>::infinity());

  double time() const { return time_; }  ///< s
  std::size_t steps() const { return steps_; }
  double dissipated() const { return dissipated_; }  ///< heat made by viscosity so far, J

 private:
  void renew_neighbours();
  void evaluate();
  void check_health() const;

  Backend& backend_;
  TimeStepRule rule_;
  Domain* domain_;
  double time_ = 0;
  double dissipated_ = 0;
  std::size_t steps_ = 0;
};

}  // namespace sabo
