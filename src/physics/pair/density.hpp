#pragma once

#include "physics/pair/geometry.hpp"

namespace sabo {

/// Continuity (paper Eq. 7): drho_i/dt += m_j (v_i - v_j) . grad_i W_ij, kg/m3/s.
template <class T>
SABO_HD inline T continuity(const PairGeometry<T>& pair, const Vec3<T>& v_ij, T mass_j) {
  return mass_j * pair.gradient * dot(v_ij, pair.x);
}

/// Density diffusion (paper Eqs. 10-11; Molteni & Colagrossi 2009), per kg/m3 of reference density:
/// zeta h c0 m_j psi_ij . grad_i W_ij, psi_ij = 2 (rho_i/rho_j - 1) x_ij / (r^2 + 0.01 h^2).
/// The denominator is printed as a product, a misprint. A positive excess of i decays because
/// grad W points against x_ij. Densities enter as excess e = rho/rho0 - 1, which keeps its digits.
///
/// As published the term also flattens the density gradient that carries the fluid's weight: over
/// seconds a thin layer swells at its surface. `hydrostatic` = g / c0^2 takes that gradient out
/// (Fourtakas et al. 2019, linearised); zero leaves the published term.
template <class T>
struct DensityDiffusion {
  T two_zeta_h_c0;      ///< m2/s
  T eta2;               ///< 0.01 h^2, m2
  Vec3<T> hydrostatic;  ///< 1/m

  SABO_HD T operator()(const PairGeometry<T>& pair, T excess_i, T excess_j, T mass_j) const {
    const T ratio_minus_one = (excess_i - excess_j - dot(hydrostatic, pair.x)) / (T(1) + excess_j);
    return two_zeta_h_c0 * mass_j * ratio_minus_one * pair.gradient * pair.r2 / (pair.r2 + eta2);
  }
};

}  // namespace sabo
