#pragma once

#include "verify/verification.hpp"

namespace sabo {

// Each is one file of verify/cases, with everything that the case is about.

Verdict verify_hydrostatic(const VerifySettings& settings);
Verdict verify_rheologies(const VerifySettings& settings);
Verdict verify_startup(const VerifySettings& settings);
Verdict verify_slit(const VerifySettings& settings);
Verdict verify_incline(const VerifySettings& settings);
Verdict verify_slab(const VerifySettings& settings);
Verdict verify_slump(const VerifySettings& settings);
Verdict verify_granular_collapse(const VerifySettings& settings);
Verdict verify_frictional_dam_break(const VerifySettings& settings);
Verdict verify_invariance(const VerifySettings& settings);
Verdict verify_yohutagawa(const VerifySettings& settings);
Verdict verify_runout(const VerifySettings& settings);
Verdict verify_jet(const VerifySettings& settings);
Verdict verify_column_force(const VerifySettings& settings);
Verdict verify_spheric2(const VerifySettings& settings);
Verdict verify_taylor_green(const VerifySettings& settings);
Verdict verify_drops(const VerifySettings& settings);
Verdict verify_dam_break(const VerifySettings& settings);

}  // namespace sabo
