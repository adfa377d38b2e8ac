#include "verify/verification.hpp"

#include "verify/cases.hpp"

#include "case/default_numerics.hpp"

namespace sabo {

NumericsCase VerifySettings::numerics() const {
  NumericsCase numerics = default_numerics(method);
  numerics.threads = threads;
  if (method == Method::paper) {
    numerics.viscous_operator = ViscousOperator::morris;
    numerics.boundary_stress = BoundaryStress::mirror;
    numerics.boundary_pressure = BoundaryPressure::extrapolated;
    numerics.diffusion_form = DiffusionForm::fourtakas;
  }
  return numerics;
}

const std::vector<Verification>& verifications() {
  static const std::vector<Method> both{Method::fast, Method::paper};
  static const std::vector<Verification> list{
      {"slab", "Frictional slab on an infinite slope, from rest",
       "the same rheology in one dimension, by finite volumes", both, verify_slab},
      {"runout",
       "Run-out of a block from 33 to 5 degrees, by both methods",
       "explicit two-point viscosity (Morris et al. 1997) and walls of Adami et al. (2012)",
       {Method::fast},
       verify_runout},
      {"taylor-green", "Vortices in a periodic box decay by viscosity",
       "exact solution of Taylor and Green (1937)", both, verify_taylor_green},
      {"drops", "A drop drawn out by a strain flow, and one that oscillates in a central force",
       "ordinary differential equations of Monaghan (1994) and Monaghan & Rafiee (2013)", both,
       verify_drops},
      {"dam-break", "A column of water collapses onto a dry floor",
       "Martin & Moyce (1952), Tables 2 and 6, n^2 = 2, a = 2.25 in", both, verify_dam_break},
  };
  return list;
}

}  // namespace sabo
