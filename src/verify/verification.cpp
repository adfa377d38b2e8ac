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
      {"invariance", "A slump that is turned, moved, computed otherwise",
       "the same slump; for a single step to rounding", both, verify_invariance},
      {"runout",
       "Run-out of a block from 33 to 5 degrees, by both methods",
       "explicit two-point viscosity (Morris et al. 1997) and walls of Adami et al. (2012)",
       {Method::fast},
       verify_runout},
      {"yohutagawa", "The event of 2010 on generated terrain, with and without pore pressure",
       "the run published with the method (doi:10.1007/s11069-016-2171-x), on its own terrain",
       both, verify_yohutagawa},
  };
  return list;
}

}  // namespace sabo
