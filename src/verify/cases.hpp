#pragma once

#include "verify/verification.hpp"

namespace sabo {

// Each is one file of verify/cases, with everything that the case is about.

Verdict verify_slab(const VerifySettings& settings);
Verdict verify_runout(const VerifySettings& settings);
Verdict verify_taylor_green(const VerifySettings& settings);
Verdict verify_drops(const VerifySettings& settings);
Verdict verify_dam_break(const VerifySettings& settings);

}  // namespace sabo
