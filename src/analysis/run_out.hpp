#pragma once

#include <optional>
#include <vector>

#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// Where a footprint ends and where its middle lies.
struct FootprintPlace {
  double station = 0;     ///< of its farthest cell along a path, m
  double centroid_x = 0;  ///< of its area
  double centroid_y = 0;
};

/// Of the cells of a grid whose indices are given; nothing without a cell. `path` needs two
/// different vertices and is continued straight beyond its ends.
std::optional<FootprintPlace> place_of(const Grid& grid, const std::vector<std::size_t>& cells,
                                       const Polyline& path);

/// Arrival time (s) at a place: of its cell, else the earliest of the eight cells around; none
/// where the flow never came, and outside the grid.
std::optional<double> arrival_at(const Raster& arrival, double x, double y);

}  // namespace sabo
