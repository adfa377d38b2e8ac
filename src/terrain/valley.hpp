#pragma once

#include "terrain/check_dam.hpp"
#include "terrain/polyline.hpp"
#include "terrain/raster.hpp"
#include "terrain/release.hpp"

namespace sabo {

// The valley of the example `yohutagawa`: terrain generated from the published numbers of the 2010
// debris flow at Yohutagawa, Amami Oshima (slopes, lengths, volumes), because the site's DEM is not
// public. It is not the real terrain, and results on it are a consistency check only.
//
// A steep channel that meanders, flattens from 33 to 4 degrees and opens to a fan. x runs down the
// valley from 0 to 1200 m, y to its left; "distance from the axis" is measured along y.

/// Slope of the channel bed along x, degrees.
double valley_slope(double x);

/// Elevation of the channel bed on its axis, m; 250 at x = 0.
double valley_bed(double x);

/// y of the channel's axis, m.
double valley_axis(double x);

/// Elevation of the ground, m.
double valley_elevation(double x, double y);

/// The ground over 0 <= x <= 1200 m and |y| <= half_width.
Raster valley_dem(double cell_size, double half_width = 80);

/// The axis with the elevations of the bed, a vertex every 5 m.
Polyline valley_path();

/// The source: 5 m deep on the axis, tapering to nothing 14 m from it, from x = 25 m down to where
/// it holds 8863 m3.
ReleaseShape valley_release();

/// The check dam at x = 620 m: across the channel into both sides, 3.2 m thick, its crest 8 m above
/// the bed, with a notch 10 m wide and 1.5 m deep on the axis.
CheckDam valley_dam();

}  // namespace sabo
