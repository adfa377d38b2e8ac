#pragma once

#include <array>

#include <ogr_spatialref.h>

#include "terrain/raster.hpp"

namespace sabo {

/// A grid that covers a raster in another coordinate system or of another cell size.
struct WarpPlan {
  Grid grid;
  bool averages = false;  ///< mean of the cells below each new one, else bilinear
};

/// Plans square cells of `cell_size` in units of `to`; 0 takes that of the source, or in another
/// unit about it, a round number. In the same coordinate system (or when both are unknown) the
/// north-west corner stays; in another one, edges are multiples of the cell size. Both are read
/// without their vertical part, x first. Throws CaseError at terrain.crs when there is no way from
/// one to the other, at terrain.cell_size when that gives less than 2 x 2 or too many cells.
WarpPlan plan_warp(const Grid& source, const OGRSpatialReference& from,
                   const OGRSpatialReference& to, double cell_size);

/// [west, south, east, north] in `from` of what a grid in `to` needs, with a margin for the
/// interpolation. Throws CaseError at terrain.crs.
std::array<double, 4> source_bounds(const Grid& target, const Grid& source,
                                    const OGRSpatialReference& from, const OGRSpatialReference& to);

/// Values on another grid, the same for any number of processors.
///
/// Finer or equal cells are bilinear: that passes through the values, keeps a plane a plane and
/// never leaves the range of the four cells around, so neither peaks nor edges overshoot, as they
/// do with cubic splines. Coarser cells are means, weighted by the area of the cells below. No data
/// takes no part: a bilinear cell has data when the source cell at its centre has, a mean when any
/// cell below it has. At the rim of the data the bilinear value is that of the cells that are
/// there. Elevations are not changed from one vertical datum to another.
Raster warp(const Raster& source, const OGRSpatialReference& from, const WarpPlan& plan,
            const OGRSpatialReference& to);

}  // namespace sabo
