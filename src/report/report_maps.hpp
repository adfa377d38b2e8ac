#pragma once

#include <string>

#include "report/report_parts.hpp"

#include "io/output/map_picture.hpp"
#include "io/output/map_style.hpp"

namespace sabo {

/// Depth above which the run counted a cell as wet, m.
double wet_depth_of(const RunRecord& run);

/// Part of the map that the flow has touched, with some room around it.
MapView view_of_flow(RunRecord& run);

/// The map `name` with the lines of the plan over the hillshade of the ground, and below it where
/// it is from; says what is missing.
void add_map(Report& report, const std::string& name, const MapStyle& style);

/// The same over the whole DEM, with a frame around the part that the other maps show.
void add_location_map(Report& report);

/// Names of the kinds of lines that the plan has.
void add_map_key(Report& report);

}  // namespace sabo
