#pragma once

#include "run/batch.hpp"
#include "run/sweep_plan.hpp"

namespace sabo {

/// Runs a case with each combination of values, see make_runs(), and writes a table of what came
/// out, charts of it, and for some depths the share of the runs in which a place was flooded
/// deeper. Throws CaseError, and RunError when the results cannot be written.
BatchResult run_sweep(const SweepRequest& request, const BatchOptions& options);

}  // namespace sabo
