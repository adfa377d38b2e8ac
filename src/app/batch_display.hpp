#pragma once

#include <functional>
#include <string>

#include "run/batch.hpp"

namespace sabo {

/// Carries a batch of runs out with progress lines and says what came of it; the exit code.
int show_batch(const std::string& folder,
               const std::function<BatchResult(const BatchOptions&)>& batch);

}  // namespace sabo
