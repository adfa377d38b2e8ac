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

FlowModel VerifySettings::model(const MaterialCase& material, const NumericsCase& numerics,
                                double release_depth) const {
  FlowModel model = flow_model(material, numerics, release_depth);
  alter(model);
  return model;
}

const std::vector<Verification>& verifications() {
  static const std::vector<Method> both{Method::fast, Method::paper};
  static const std::vector<Verification> list{
      {"rheologies",
       "Bingham's fluid and the laws that stand in for it",
       "figure 1 of the paper (doi:10.1007/s11069-016-2171-x)",
       {Method::fast},
       verify_rheologies},
      {"hydrostatic", "Fluids at rest over floors, a wedge and DEMs", "p = ρ g (H - z)", both,
       verify_hydrostatic,
       "dynamic boundaries, the default of DualSPHysics, leave a gap at walls; with its mDBC the "
       "pressure of still water converges to the hydrostatic one (English et al. 2022, "
       "doi:10.1007/s40571-021-00403-3)"},
      {"startup", "Poiseuille and Couette flow from rest",
       "series of Morris, Fox & Zhu (1997), Eqs. 22 and 23", both, verify_startup,
       "close agreement with the series is reported for the method that brought the case up, "
       "Morris et al. (1997)"},
      {"slit", "Fluids with a yield stress between two plates",
       "the law of each, integrated over the known stress", both, verify_slit},
      {"incline", "Layers with friction or a yield stress down an incline",
       "the law of each, integrated over the weight of the layer", both, verify_incline},
      {"slab", "Frictional slab on an infinite slope, from rest",
       "the same rheology in one dimension, by finite volumes", both, verify_slab,
       "the stress sum of the paper; with walls that carry no stress, as in the laminar stress of "
       "DualSPHysics 5 (JSphCpu.cpp), it moves the slab several times too fast: see the values of "
       "the nested sum"},
      {"invariance", "A slump that is turned, moved, computed otherwise",
       "the same slump; for a single step to rounding", both, verify_invariance},
      {"slump",
       "A square column of a Bingham fluid slumps until its yield stress carries it",
       "plane slump with stress along the bed (Dubash et al. 2009)",
       {Method::fast},
       verify_slump,
       "depth-averaged theory without the stress along the bed stops at 0.282 m for B 0.05 and "
       "0.483 m for B 0.01: 18 and 5 % farther"},
      {"granular-collapse",
       "Columns of grains collapse on a level bed",
       "Lube et al. 2005, Lajeunesse et al. 2005; contact dynamics (Lagrée, Staron & Popinet 2011)",
       {Method::fast},
       verify_granular_collapse,
       "a volume-of-fluid code with μ(I) meets the profiles of contact dynamics (Lagrée, Staron & "
       "Popinet 2011, doi:10.1017/jfm.2011.335); an elastoplastic SPH of soil differs from "
       "measured "
       "profiles of columns with a = 0.5 and 1 by about 1 % (Feng et al. 2021, "
       "doi:10.1016/j.compgeo.2021.104356)"},
      {"frictional-dam-break",
       "Dam break on a frictional slope",
       "depth-averaged solution (Mangeney et al. 2000)",
       {Method::fast},
       verify_frictional_dam_break,
       "the solution is itself the test of depth-averaged codes"},
      {"runout",
       "Run-out of a block from 33 to 5 degrees, by both methods",
       "explicit two-point viscosity (Morris et al. 1997) and walls of Adami et al. (2012)",
       {Method::fast},
       verify_runout},
      {"yohutagawa", "The event of 2010 on generated terrain, with and without pore pressure",
       "the run published with the method (doi:10.1007/s11069-016-2171-x), on its own terrain",
       both, verify_yohutagawa},
      {"jet", "Force of a plane jet on a plate",
       "momentum theorem: F = rho b u^2 (Batchelor 1967, section 6.3)", both, verify_jet},
      {"column-force", "Force of a dam break on a square column",
       "Yeh & Petroff, in Raad & Bidoae, J. Comput. Phys. 203 (2005), Fig. 18", both,
       verify_column_force,
       "the SPH of Ansys Rocky has a peak of 31.2 N on a square column where 33.3 N were measured "
       "(Ansys Rocky, verification manual 2024 R2, section 4.4)"},
      {"spheric2",
       "Dam break on a box (SPHERIC test 2)",
       "experiment of MARIN, Kleefsman et al., J. Comput. Phys. 206 (2005); SPHERIC release",
       {Method::fast},
       verify_spheric2,
       "DualSPHysics with mDBC: pressures on the box in close agreement with the experiment "
       "(English et al. 2022, doi:10.1007/s40571-021-00403-3)"},
      {"taylor-green", "Vortices in a periodic box decay by viscosity",
       "exact solution of Taylor and Green (1937)", both, verify_taylor_green,
       "the usual sums of weakly compressible SPH do not converge to second order even here; "
       "consistent ones do (Negi & Ramachandran 2022, arXiv:2107.11859)"},
      {"drops", "A drop drawn out by a strain flow, and one that oscillates in a central force",
       "ordinary differential equations of Monaghan (1994) and Monaghan & Rafiee (2013)", both,
       verify_drops,
       "a test of TrixiParticles.jl asks for a within 2e-4 after one period at R/dp = 20 (its "
       "test/examples/examples_fluid.jl), by one particle at one moment"},
      {"dam-break", "A column of water collapses onto a dry floor",
       "Martin & Moyce (1952), Tables 2 and 6, n^2 = 2, a = 2.25 in, as they stand in example code "
       "of others",
       both, verify_dam_break,
       "fronts of SPH run ahead of experiments with dam breaks (Jonsson et al. 2015, "
       "doi:10.4236/eng.2015.75022)"},
  };
  return list;
}

}  // namespace sabo
