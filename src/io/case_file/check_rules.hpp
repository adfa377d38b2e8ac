#pragma once

#include "base/faults.hpp"
#include "case/case.hpp"

namespace sabo {

/// Adds a fault for each rule of the case that spans several keys and is broken. A key that already
/// has a fault counts as given.
void check_rules(const Case& c, Faults& faults);

}  // namespace sabo
