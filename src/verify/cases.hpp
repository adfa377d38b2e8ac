#pragma once

#include "verify/verification.hpp"

namespace sabo {

// Each is one file of verify/cases, with everything that the case is about.

Verdict verify_slab(const VerifySettings& settings);
Verdict verify_invariance(const VerifySettings& settings);
Verdict verify_yohutagawa(const VerifySettings& settings);
Verdict verify_runout(const VerifySettings& settings);

}  // namespace sabo
