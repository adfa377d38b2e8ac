#pragma once

#include "math/scalar.hpp"
#include "math/sym3.hpp"
#include "physics/pair/geometry.hpp"

namespace sabo {

/// Pressure and nested viscous force (paper Eqs. 13 and 18), m/s2:
/// m_j (s_i + s_j) . grad_i W_ij with s = (tau - p I) / rho^2. Antisymmetric: momentum is exact.
template <class T>
SABO_HD inline Vec3<T> stress_force(const PairGeometry<T>& pair, const Sym3<T>& s_i,
                                    const Sym3<T>& s_j, T mass_j) {
  return (mass_j * pair.gradient) * ((s_i + s_j) * pair.x);
}

/// Pressure force alone, m/s2: - m_j (P_i + P_j) grad_i W_ij with P = p / rho^2 (paper Eq. 13).
template <class T>
SABO_HD inline Vec3<T> pressure_force(const PairGeometry<T>& pair, T p_i, T p_j, T mass_j) {
  return (-mass_j * pair.gradient * (p_i + p_j)) * pair.x;
}

/// Power of the pressure in Eq. 13, W/kg: v_i times its acceleration, from P = p / rho^2 of both.
template <class T>
SABO_HD inline T pressure_power(const PairGeometry<T>& pair, const Vec3<T>& v_i, T p_i, T p_j,
                                T mass_j) {
  return -mass_j * pair.gradient * (p_i + p_j) * dot(v_i, pair.x);
}

/// What the motion of a particle and its compression lose together where it meets a wall, W/kg: the
/// power of pressure above and P_i times its rate of density (Eq. 7). Between two particles of the
/// flow both together lose nothing; a wall keeps it as its own compression, or does not.
template <class T>
SABO_HD inline T pressure_loss(const PairGeometry<T>& pair, const Vec3<T>& v_i, const Vec3<T>& v_j,
                               T p_i, T p_j, T mass_j) {
  return mass_j * pair.gradient * dot(p_j * v_i + p_i * v_j, pair.x);
}

/// Viscosity between two particles: the harmonic mean, which keeps the stress continuous where
/// yielded meets unyielded material (Cleary & Monaghan 1999). Zero if both are zero.
template <class T>
SABO_HD inline T pair_viscosity(T mu_i, T mu_j) {
  return T(2) * mu_i * mu_j / larger(mu_i + mu_j, T(1e-30));
}

/// Two-point viscous force (Morris et al. 1997, Eq. 22), m/s2:
/// 2 mu_ij m_j / (rho_i rho_j) F r^2 / (r^2 + eta^2) v_ij; F is negative, so it opposes v_ij.
template <class T>
SABO_HD inline Vec3<T> morris_force(const PairGeometry<T>& pair, const Vec3<T>& v_ij, T mu_ij,
                                    T mass_j_over_densities, T eta2) {
  const T damping =
      T(2) * mu_ij * mass_j_over_densities * pair.gradient * pair.r2 / (pair.r2 + eta2);
  return damping * v_ij;
}

/// The same force as a conductance of the implicit solve (physics/pair/viscous_flux.hpp), kg/s: i
/// gains the momentum -a_ij v_ij per time. Positive. Without eta^2: F of this kernel is finite at
/// r = 0, so nothing wants regularising, and at h/dp = 1.5 eta^2 takes 1 % of the viscosity away.
template <class T>
SABO_HD inline T viscous_conductance(const PairGeometry<T>& pair, T mu_ij, T volume_i, T volume_j) {
  return T(-2) * mu_ij * (volume_i * volume_j) * pair.gradient;
}

/// What the pair's artificial viscosity makes of its motion, m/s2 and W/kg of particle i, whose
/// share of the heat is half.
template <class T>
struct ArtificialViscosity {
  Vec3<T> acceleration;
  T heat;
};

/// Artificial viscosity (Monaghan 1992): - m_j Pi_ij grad W with
/// Pi_ij = - alpha c0 h (v.x) / ((r^2 + eta^2) rho_mean) for approaching pairs, else 0.
template <class T>
SABO_HD inline ArtificialViscosity<T> artificial_viscosity(const PairGeometry<T>& pair,
                                                           const Vec3<T>& v_ij, T alpha_c0_h,
                                                           T mass_j_over_mean_density, T eta2) {
  const T approach = dot(v_ij, pair.x);
  const T closing = smaller(approach, T(0));
  const T strength =
      alpha_c0_h * mass_j_over_mean_density * pair.gradient * closing / (pair.r2 + eta2);
  return {strength * pair.x, T(-0.5) * strength * approach};
}

}  // namespace sabo
