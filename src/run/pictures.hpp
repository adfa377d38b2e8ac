#pragma once

#include <vector>

#include "io/output/colour_scale.hpp"
#include "io/output/index_page.hpp"
#include "run/run_maps.hpp"
#include "run/scene.hpp"
#include "run/series_row.hpp"
#include "run/structure_loads.hpp"

namespace sabo {

/// Classes of depth in particles: too few in orange, enough in violet.
std::vector<ColourStep> resolution_steps();

/// Draws maps and series; returns the pictures for the index page.
std::vector<PagePicture> draw_pictures(const RunMaps& maps, const std::vector<SeriesRow>& rows,
                                       const std::vector<LoadSummary>& loads, const Case& c,
                                       const Scene& scene, const RunFolder& folder);

}  // namespace sabo
