#pragma once

#include <string>
#include <vector>

#include "io/output/svg_chart.hpp"
#include "physics/rheology_list.hpp"

namespace sabo {

/// Laws of flow over the shear rate.
struct ModelsPlot {
  LineChart effective_viscosity;
  LineChart shear_stress;
};

/// Draws laws at one yield stress and effective pressure (Pa) from 1e-4 to 1e3 1/s; at.rate is not
/// used. Curves of stress end at three times `at.yield_stress`, where there is one. `conditions`
/// stands in the titles. Throws CaseError when there is no law to draw.
ModelsPlot plot_models(const std::vector<Rheology>& laws, const Shear& at,
                       const std::string& conditions);

}  // namespace sabo
