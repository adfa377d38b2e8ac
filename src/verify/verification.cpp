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
      {"jet", "Force of a plane jet on a plate",
       "momentum theorem: F = rho b u^2 (Batchelor 1967, section 6.3)", both, verify_jet},
      {"column-force", "Force of a dam break on a square column",
       "Yeh & Petroff, in Raad & Bidoae, J. Comput. Phys. 203 (2005), Fig. 18", both,
       verify_column_force},
      {"spheric2",
       "Dam break on a box (SPHERIC test 2)",
       "experiment of MARIN, Kleefsman et al., J. Comput. Phys. 206 (2005); SPHERIC release",
       {Method::fast},
       verify_spheric2},
  };
  return list;
}

}  // namespace sabo
