#pragma once

#include <string>
#include <vector>

#include "io/output/index_page.hpp"
#include "run/recorder.hpp"

namespace sabo {

/// The four maps of a run in CRS coordinates.
struct RunMaps {
  Raster deposit;     ///< dep, m
  Raster peak_depth;  ///< pfd, m
  Raster peak_speed;  ///< pfv, m/s
  Raster arrival;     ///< tarr, s
};

/// Writes the maps as GeoTIFF.
void write_maps(const RunMaps& maps, const Case& c, const Scene& scene, const RunFolder& folder);

/// Draws maps and series; returns the pictures for the index page.
std::vector<PagePicture> draw_pictures(const RunMaps& maps, const std::vector<SeriesRow>& rows,
                                       const Case& c, const Scene& scene, const RunFolder& folder);

}  // namespace sabo
