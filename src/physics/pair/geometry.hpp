#pragma once

#include <cmath>

#include "math/vec3.hpp"
#include "physics/kernel.hpp"

namespace sabo {

/// What every pair term needs to know of a pair i, j.
template <class T>
struct PairGeometry {
  Vec3<T> x;   ///< x_i - x_j, m
  T r2;        ///< |x|^2
  T gradient;  ///< F in grad_i W_ij = F x, 1/m^(D+2); zero beyond the support
};

template <class T>
SABO_HD inline PairGeometry<T> pair_geometry(const Vec3<T>& x, const WendlandC2<T>& kernel) {
  using std::sqrt;
  const T r2 = dot(x, x);
  return {x, r2, kernel.gradient_factor(sqrt(r2))};
}

}  // namespace sabo
