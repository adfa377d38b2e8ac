#pragma once

#include <string>
#include <vector>

#include "io/output/colour_scale.hpp"
#include "io/output/index_page.hpp"
#include "run/recorder.hpp"

namespace sabo {

/// The maps of a run, in the solver frame.
struct RunMaps {
  Raster deposit;           ///< dep, m
  Raster peak_depth;        ///< pfd, m
  Raster peak_speed;        ///< pfv, m/s
  Raster peak_pressure;     ///< ppr, Pa; kPa in its file and picture
  Raster peak_momentum;     ///< pmf, N/m; kN/m in its file and picture
  Raster arrival;           ///< tarr, s
  Raster layers;            ///< res, particles
  double wet_depth = 0.05;  ///< above which a cell counted as wet, m
};

/// Classes of depth in particles: too few in orange, enough in violet.
std::vector<ColourStep> resolution_steps();

/// Writes the maps as GeoTIFF; that of the ground is there from the start, see scene_record.
void write_maps(const RunMaps& maps, const Case& c, const Scene& scene, const RunFolder& folder);

/// Draws maps and series; returns the pictures for the index page.
std::vector<PagePicture> draw_pictures(const RunMaps& maps, const std::vector<SeriesRow>& rows,
                                       const std::vector<LoadSummary>& loads, const Case& c,
                                       const Scene& scene, const RunFolder& folder);

}  // namespace sabo
