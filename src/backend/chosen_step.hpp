#pragma once

#include "physics/time_step.hpp"

namespace sabo {

/// How long a step is. Found where the flow is: no sweep has to wait until the host knows it.
struct ChosenStep {
  FlowExtremes flow;  ///< at its start
  double dt = 0;      ///< s
};

/// How exact the implicit velocity has to be: over a step dt the residual ends below
/// dt (rate + share x greatest acceleration), m/s.
struct VelocityTolerance {
  double rate = 0;   ///< m/s2
  double share = 0;  ///< of the greatest acceleration

  SABO_HD double over(const ChosenStep& step) const {
    return step.dt * (rate + share * step.flow.acceleration);
  }
};

}  // namespace sabo
