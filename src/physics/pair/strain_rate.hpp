#pragma once

#include "math/sym3.hpp"
#include "physics/pair/geometry.hpp"

namespace sabo {

/// Least filled share of the kernel by which derivatives are divided: below it the sum is too poor
/// to be made up for.
inline constexpr double least_support = 0.4;

/// Contribution of j to eps = grad v + (grad v)^T at i, 1/s: - V_j (v_ij (x) grad W + transposed),
/// V_j = m_j / rho_j (paper Eqs. 16-17 without the printed factor 1/2).
template <class T>
SABO_HD inline Sym3<T> strain_rate(const PairGeometry<T>& pair, const Vec3<T>& v_ij, T volume_j) {
  return symmetric_product((-volume_j * pair.gradient) * v_ij, pair.x);
}

/// Engineering shear rate sqrt(eps:eps / 2), 1/s: du/dz in simple shear.
template <class T>
SABO_HD inline T shear_rate(const Sym3<T>& eps) {
  using std::sqrt;
  return sqrt(double_dot(eps, eps) / T(2));
}

}  // namespace sabo
