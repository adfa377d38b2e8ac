#pragma once

#include <string>
#include <vector>

#include "physics/rheology_list.hpp"

namespace sabo {

/// Charts of laws of flow over the shear rate, as SVG files.
struct ModelsPlot {
  std::string effective_viscosity;
  std::string shear_stress;
};

/// Draws laws at one yield stress and effective pressure (Pa) from 1e-4 to 1e3 1/s; at.rate is not
/// used. Curves of stress end at three times `at.yield_stress`, where there is one. `conditions`
/// stands in the titles. Throws CaseError when there is no law to draw.
ModelsPlot plot_models(const std::vector<Rheology>& laws, const Shear& at,
                       const std::string& conditions);

}  // namespace sabo
