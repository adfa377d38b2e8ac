#pragma once

#include <algorithm>

#include "backend/model.hpp"

namespace sabo {

/// Share of a negative pressure that a particle bears, by the share of its kernel that has
/// neighbours: the two outer rows of a flow have less than 0.9, those inside more than 0.95.
SABO_HD inline double borne_tension(const FlowModel& model, double support) {
  constexpr double none = 0.9, all = 0.95;
  return model.tension_at_surface ? 1 : std::clamp((support - none) / (all - none), 0.0, 1.0);
}

}  // namespace sabo
