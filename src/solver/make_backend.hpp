#pragma once

#include <memory>

#include "backend/backend.hpp"
#include "case/case.hpp"

namespace sabo {

/// The one list of backends.
std::unique_ptr<Backend> make_backend(BackendKind kind, const FlowModel& model);

}  // namespace sabo
