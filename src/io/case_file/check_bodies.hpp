#pragma once

#include <vector>

#include "base/faults.hpp"
#include "case/body_case.hpp"

namespace sabo {

/// Adds a fault for each key that a body of its kind lacks or cannot have, and for boxes without a
/// volume.
void check_bodies(const std::vector<BodyCase>& bodies, Faults& faults);

}  // namespace sabo
