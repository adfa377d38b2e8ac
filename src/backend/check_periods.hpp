#pragma once

#include <string>

#include "backend/model.hpp"
#include "base/error.hpp"

namespace sabo {

/// Otherwise two images of one particle could both be listed. Throws CaseError for a period shorter
/// than two radii (m) of the neighbour list.
inline void check_periods(const FlowModel& model, double list_radius) {
  const double shortest = 2 * list_radius;
  for (int axis = 0; axis < 3; ++axis)
    if (model.periodic.on(axis) && Periodic::along(model.periodic.period[axis], axis) < shortest)
      throw CaseError("periodic", "a period is shorter than two radii of the neighbour list",
                      "make it at least " + std::to_string(shortest) + " m");
}

}  // namespace sabo
