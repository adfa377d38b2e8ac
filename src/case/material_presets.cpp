#include "case/material_presets.hpp"

#include <algorithm>

namespace sabo {

const std::vector<MaterialPreset>& material_presets() {
  static const std::vector<MaterialPreset> presets{
      {"yohutagawa_2010", "debris flow of 2010 at Yohutagawa, Japan, as simulated in 2016",
       "Natural Hazards 81 (2016) 1981-1998, doi 10.1007/s11069-016-2171-x: friction angle and "
       "viscosity",
       "Density from 44 % of solids of 2650 kg/m3 in water, cohesion 0: both are assumptions. The "
       "viscosity is that of a formula whose unit is in doubt (docs/rheology/README.md), best read "
       "as a calibrated value",
       1726, Cross{1255, 1000, 1}, MohrCoulomb{0, 28, 0}},
      {"mud_glenwood_4", "muddy debris flow, stiff: Glenwood 4 at 40 % of solids",
       "O'Brien & Julien, J. Hydraul. Eng. 114 (1988) 877-887: tau_B = 0.172e-3 exp(29.5 C) Pa, "
       "mu_B = 0.0602e-3 exp(33.1 C) Pa s, C = 0.40",
       "Fine matrix only, measured at low shear rates; 5 percentage points more of solids give 4 "
       "to 5 times the stress and viscosity. Coefficients not checked against the original",
       1660, Bingham{{33.9, 1000}}, MohrCoulomb{22.9, 0, 0}},
      {"mud_aspen_pit_1", "mudflow, strong and fluid: Aspen Pit 1 at 35 % of solids",
       "O'Brien & Julien, J. Hydraul. Eng. 114 (1988) 877-887: tau_B = 0.0181 exp(25.7 C) Pa, "
       "mu_B = 3.60e-3 exp(22.1 C) Pa s, C = 0.35",
       "Fine matrix only, measured at low shear rates. Coefficients not checked "
       "against the original",
       1578, Bingham{{8.23, 1000}}, MohrCoulomb{146, 0, 0}},
      {"water_clay", "water and clay in a laboratory dam break",
       "Komatina & Jovanovic, J. Hydraul. Res. 35 (1997) 579-590; values as used by Shao & Lo, "
       "Adv. Water Resour. 26 (2003) 787-800",
       "Laboratory fluid for the comparison of codes, no debris flow. Values not checked against "
       "the original",
       1200, Cross{0.07, 1000, 1}, MohrCoulomb{25, 0, 0}},
      {"carbopol_030", "Carbopol Ultrez 10 at 0.30 %, a clear viscoplastic gel",
       "Cochard & Ancey, J. Non-Newtonian Fluid Mech. 158 (2009) 73-84",
       "Laboratory fluid for the comparison of codes; the yield stress of single batches lay "
       "between 78 and 109 Pa. Values not checked against the original",
       1000, HerschelBulkley{47.7, 0.415, 100, 1e5}, MohrCoulomb{89, 0, 0}},
      {"glass_beads", "dry glass beads of 0.53 mm",
       "Jop, Forterre & Pouliquen, Nature 441 (2006) 727-730: mu_s = tan 20.9 deg, mu_2 = "
       "tan 32.76 deg, I_0 = 0.279",
       "Dry grains without cohesion; the law is ill-posed in slow and in very fast flow. Density "
       "from 60 % of beads of 2450 kg/m3",
       1470, MuI{0.2616, 0.279, 0.00053, 2450, 0.1, 1e4}, MohrCoulomb{0, 20.9, 0}}};
  return presets;
}

const MaterialPreset* find_preset(std::string_view name) {
  const auto& presets = material_presets();
  const auto found = std::ranges::find(presets, name, &MaterialPreset::name);
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace sabo
