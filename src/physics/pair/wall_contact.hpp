#pragma once

#include "physics/pair/density.hpp"

// Density of fluid at walls whose pressure is extrapolated from the fluid (Adami et al. 2012).
// Force and density rate belong together: what a push takes from the motion must come back as
// compression, as it does between two fluid particles (Bonet & Lok 1999 derive one from the other).
// A wall at rest gives back only the half that belongs to the pressure of the fluid.
//
// So a wall hands back what its own pressure took. That pressure is a mean of the fluid's with the
// weights W_wj, hence the compression goes to the same fluid by the same weights. With walls that
// take no part in it a slump 14 particles high loses 4 % of its energy to them.
//
// And contact is one-sided: fluid below its reference density is not stretched further by leaving
// a wall.

namespace sabo {

/// What a fluid neighbour adds to the rate at which fluid closes in on wall particle w, 1/(m^D s):
/// (v_w - v_j) . grad_w W_wj. The pair and the velocity difference are seen from the wall.
template <class T>
SABO_HD inline T closing(const PairGeometry<T>& pair, const Vec3<T>& v_wj) {
  return pair.gradient * dot(v_wj, pair.x);
}

/// Density rate that a wall neighbour hands back, kg/m3/s. Over the sum of the weights W at the
/// wall particle, which must be under pressure, `closing` is the sum of closing() and `gradient`
/// that of grad_w W_wj. Seen by the particle as it slides along the wall, so that a front that runs
/// over a floor does not count as fluid that closes in on what lies before it.
template <class T>
SABO_HD inline T handed_back(T mass_times_weight, const Vec3<T>& v_along, T closing,
                             const Vec3<T>& gradient) {
  return mass_times_weight * (closing + dot(v_along, gradient));
}

/// Density rate of a particle by all its wall neighbours, by the sum over them.
template <class T>
SABO_HD inline T one_sided(T wall_rate, T excess) {
  return excess < T(0) ? larger(wall_rate, T(0)) : wall_rate;
}

}  // namespace sabo
