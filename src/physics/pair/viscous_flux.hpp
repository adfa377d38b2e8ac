#pragma once

#include <cmath>

#include "math/scalar.hpp"
#include "math/sym3.hpp"
#include "physics/pair/geometry.hpp"

// What a viscous fluid carries across a plane is mu (grad v + grad v^T). The two-point form of
// Morris et al. (1997) carries mu grad v, within a per cent for any arrangement of the particles.
// That is right in shear; but a body that is squeezed in a plane bears half of its stress, and one
// that turns as a whole is braked. The second term comes from the velocity gradients G of both
// particles. Per time i hands to j the momentum
//
//   a_ij (v_ij + (G_i + G_j)^T x_ij / 2),   G_i = S_i B_i S_i,   S_i = C_i^(-1/2),
//   B_i = sum_j a_ij v_ij (x) x_ij,         C_i = sum_j a_ij x_ij (x) x_ij,
//
// a_ij the conductance of the pair. Inside of a flow C is isotropic and G the velocity gradient.
// All of it takes the power
//
//   1/2 sum_i (sum_j a_ij |v_ij|^2 + (B_i S_i) : (B_i S_i)^T),
//
// so that the matrix is symmetric and momentum is kept. |B S|^2 is at most sum_j a_ij |v_ij|^2: it
// is what the best linear velocity, by least squares, has of that sum. So the power is never
// negative, however particles lie and viscosities differ.

namespace sabo {

/// Gradients of the three components of a velocity, 1/s.
template <class T>
struct VelocityGradient {
  Vec3<T> x, y, z;

  SABO_HD VelocityGradient& operator+=(const VelocityGradient& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
};

/// At least the greatest eigenvalue of a, and no more where all are equal or there are but two
/// (Wolkowicz & Styan, Linear Algebra Appl. 29 (1980) 471-506, Theorem 2.1). In two dimensions, x
/// and z, the row of y is zero.
SABO_HD inline double eigenvalue_bound(const Sym3<double>& a, int dimension) {
  const double mean = trace(a) / dimension;
  const double variance = double_dot(a, a) / dimension - mean * mean;
  return mean + std::sqrt(larger(variance, 0.0) * (dimension - 1));
}

/// C^(-1/2), or less: the first three terms of the binomial series of 1 - C/bound, all of whose
/// terms are positive. Where C is nearly isotropic they are enough: 0.3 % are missing at an
/// eigenvalue of 0.8 of the bound. Zero for a particle without a viscous neighbour.
SABO_HD inline Sym3<double> inverse_root(const Sym3<double>& c, int dimension) {
  const double bound = eigenvalue_bound(c, dimension);
  if (!(bound > 0)) return {};
  const Sym3<double> rest = isotropic(1.0) + (-1 / bound) * c;
  return (1 / std::sqrt(bound)) * (isotropic(1.0) + 0.5 * rest + 0.375 * squared(rest));
}

/// v (x) x.
template <class T>
SABO_HD inline VelocityGradient<T> outer_product(const Vec3<T>& v, const Vec3<T>& x) {
  return {v.x * x, v.y * x, v.z * x};
}

/// S B S / 2: half of G.
template <class T>
SABO_HD inline VelocityGradient<T> half_gradient(const VelocityGradient<T>& b, const Sym3<T>& s) {
  const Vec3<T> x = s * b.x, y = s * b.y, z = s * b.z;
  return {T(0.5) * (s.xx * x + s.xy * y + s.xz * z), T(0.5) * (s.xy * x + s.yy * y + s.yz * z),
          T(0.5) * (s.xz * x + s.yz * y + s.zz * z)};
}

/// G^T x.
template <class T>
SABO_HD inline Vec3<T> transposed_times(const VelocityGradient<T>& g, const Vec3<T>& x) {
  return x.x * g.x + x.y * g.y + x.z * g.z;
}

}  // namespace sabo
