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
///
/// Method fast, without artificial viscosity; roots that two formulas share count once, 2 mu_i of
/// the harmonic mean is the same for all j:
///
///                                              wall pressure   force and matrix   near motion
///   separation, from integers                        3                 3               3
///   r^2 5, root 1                                    6                 -               -
///   pair_geometry                                    -                12              12
///   kernel value                                    11                11               -
///   where r > 0: once the value                      1                 1               -
///   sum of the weight                                1                 -               -
///   w rho (P rho + g.x), its sum 1                  10                 -               -
///   pressure_force 6, its sum 3                      -                 9               -
///   pair_viscosity 4, conductance 7, its sum 1       -                12               -
///   its moments 9, their sum 6                       -                15               -
///   filling 2, its gradient 7, near or not 1         -                10               -
///   velocity difference 3, mass of j 3               -                 -               6
///   continuity 7, its sum 1 with that of
///     the diffusion 15, added to it 1                -                 -              24
///   strain_rate 19, its sum 6                        -                 -              25
///   support 2, its sum 1                             -                 -               3
///
/// Shifting: separation 3, pair_geometry 12, continuity of the shift of j 7, its sum 1.
///
/// A pair in both sweeps of a product of the viscous solve: twice separation 3 and velocity
/// difference 3, gradient 21, its transposed one times x 15 and added 3, both sums 12; what the
/// solve does with whole vectors does not count.
double flops_of_pair(std::string_view pass);

}  // namespace sabo
