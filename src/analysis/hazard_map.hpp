#pragma once

#include <map>
#include <set>

#include "case/hazard_rules.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Rasters on one grid of what the rules look at. `impact_over_house` needs none of its own.
using HazardMaps = std::map<HazardQuantity, Raster>;

/// Quantities whose rasters classify() needs: what the conditions name, and the depth.
std::set<HazardQuantity> quantities_of(const HazardRules& rules);

/// Number of the class of each cell: 1 for the last of the rules (the least), rising to the first
/// (the worst). NaN where the depth is not above `wet` (m), where no class holds, and outside the
/// domain.
Raster classify(const HazardRules& rules, const HazardMaps& maps, double wet);

/// Number of the level of each cell by the matrix of the rules, numbered as classes are, for an
/// event of a return period (years) whose classes these are. NaN where they are, and everywhere
/// for a period beyond the matrix without a level for it.
Raster levels_of(const Raster& classes, const HazardRules& rules, double return_period);

/// Takes the greater number of each cell into `worst`; NaN counts as none.
void take_worse(const Raster& other, Raster& worst);

}  // namespace sabo
