#pragma once

#include <memory>

#include "case/case.hpp"
#include "solver/stepper.hpp"

namespace sabo {

/// The one list of methods. `domain` may be null, see Stepper.
std::unique_ptr<Stepper> make_stepper(const NumericsCase& numerics, Backend& backend,
                                      Domain* domain);

}  // namespace sabo
