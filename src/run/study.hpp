#pragma once

#include "run/batch.hpp"
#include "run/study_plan.hpp"

namespace sabo {

/// Runs a case at each spacing, see make_runs(), and writes what the results say about the spacing
/// of zero. Throws CaseError, and RunError when the tables cannot be written.
BatchResult run_study(const StudyRequest& request, const BatchOptions& options);

}  // namespace sabo
