#pragma once

#include <vector>

#include "base/faults.hpp"
#include "case/structure_case.hpp"

namespace sabo {

/// Adds a fault for each key that a structure of its kind lacks or cannot have, and for openings
/// that are not in their dam or leave nothing open.
void check_structures(const std::vector<StructureCase>& structures, Faults& faults);

}  // namespace sabo
