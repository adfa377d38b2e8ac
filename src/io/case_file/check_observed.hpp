#pragma once

#include "base/faults.hpp"
#include "case/observed_case.hpp"

namespace sabo {

/// Checks what holds between keys of [observed]: a footprint is known by its depths or by its
/// outline.
void check_observed(const ObservedCase& observed, Faults& faults);

}  // namespace sabo
