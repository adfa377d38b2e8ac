#pragma once

#include <string>

#include "report/report_parts.hpp"

#include "io/output/map_picture.hpp"

namespace sabo {

/// How a map of the run is shown in the report.
struct MapStyle {
  std::string title;
  std::string quantity;  ///< with its unit
  double threshold = 0;  ///< smaller values are left out
  std::vector<ColourStep> steps = {};
};

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
