#pragma once

#include <string>
#include <vector>

#include "case/load_case.hpp"
#include "io/output/index_page.hpp"
#include "run/structure_loads.hpp"

namespace sabo {

/// The loads as tables of the manifest.
std::string loads_toml(const std::vector<LoadSummary>& loads, const LoadCase& settings);

/// The loads as a table for people, in kN; of a run with structures.
PageTable load_table(const std::vector<LoadSummary>& loads, const LoadCase& settings);

}  // namespace sabo
