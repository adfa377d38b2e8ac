#pragma once

#include <memory>
#include <string>

#include "backend/backend.hpp"
#include "case/case.hpp"

namespace sabo {

/// The one list of backends. Throws CaseError for one that cannot run here.
std::unique_ptr<Backend> make_backend(BackendKind kind, const FlowModel& model);

/// Why a backend cannot run on this machine or with this program; empty if it can.
std::string missing_backend(BackendKind kind);
/// Throws that as a CaseError with the way out.
void require_backend(BackendKind kind);

}  // namespace sabo
