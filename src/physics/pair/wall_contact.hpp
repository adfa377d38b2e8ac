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

/// Density rate by a wall neighbour, kg/m3/s: continuity at the wall as it moves, and the share in
/// what the wall hands back. `closing_per_weight`: sum of closing over the fluid at the wall
/// particle, over the sum of its weights W, 1/s; 0 for a wall without pressure.
template <class T>
SABO_HD inline T wall_continuity(const PairGeometry<T>& pair, const Vec3<T>& v_iw, T mass_w,
                                 T weight, T closing_per_weight) {
  return continuity(pair, v_iw, mass_w) + mass_w * weight * closing_per_weight;
}

/// Density rate of a particle by all its wall neighbours, by the sum over them.
template <class T>
SABO_HD inline T one_sided(T wall_rate, T excess) {
  return excess < T(0) ? larger(wall_rate, T(0)) : wall_rate;
}

}  // namespace sabo
