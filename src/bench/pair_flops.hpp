#pragma once

#include <string_view>

namespace sabo {

/// Additions, multiplications, divisions, roots, minima and maxima of one pair of fluid particles,
/// counted in src/physics with its kernel constants taken out of the loop; changes of sign and
/// conversions of integers do not count. 0 for a pass that nobody has counted: it gets no share of
/// the peak.
///
///                                               motion   force (nested, no artificial viscosity)
///   separation, from integers                     3        3
///   pair_geometry: r^2 5, root 1, gradient 6     12       12
///   velocity difference                           3        -
///   mass of j, from its volume and excess         3        -
///   continuity 7, its sum 1                       8        -
///   density diffusion 15, its sum 1              16        -
///   strain_rate 19, wall 3, its sum 6            28        -
///   stress_force 25, its sum 3                    -       28
///   pressure_power 9, its sum 1                   -       10
double flops_of_pair(std::string_view pass);

}  // namespace sabo
