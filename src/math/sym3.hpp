#pragma once

#include "base/host_device.hpp"
#include "math/vec3.hpp"

namespace sabo {

/// Symmetric 3 x 3 tensor, six components.
template <class T>
struct Sym3 {
  T xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

  SABO_HD constexpr Sym3& operator+=(const Sym3& b) {
    xx += b.xx;
    xy += b.xy;
    xz += b.xz;
    yy += b.yy;
    yz += b.yz;
    zz += b.zz;
    return *this;
  }
  friend SABO_HD constexpr Sym3 operator+(Sym3 a, const Sym3& b) { return a += b; }
  friend SABO_HD constexpr Sym3 operator*(T s, const Sym3& a) {
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
  }
  friend SABO_HD constexpr Vec3<T> operator*(const Sym3& a, const Vec3<T>& v) {
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
  }
  friend SABO_HD constexpr bool operator==(const Sym3& a, const Sym3& b) = default;
};

template <class T>
SABO_HD constexpr T trace(const Sym3<T>& a) {
  return a.xx + a.yy + a.zz;
}

/// a:b, the sum over all nine components.
template <class T>
SABO_HD constexpr T double_dot(const Sym3<T>& a, const Sym3<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + T(2) * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// a (x) b + b (x) a.
template <class T>
SABO_HD constexpr Sym3<T> symmetric_product(const Vec3<T>& a, const Vec3<T>& b) {
  return {T(2) * a.x * b.x, a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x,
          T(2) * a.y * b.y, a.y * b.z + a.z * b.y, T(2) * a.z * b.z};
}

/// s a (x) a.
template <class T>
SABO_HD constexpr Sym3<T> scaled_square(T s, const Vec3<T>& a) {
  const Vec3<T> b = s * a;
  return {b.x * a.x, b.x * a.y, b.x * a.z, b.y * a.y, b.y * a.z, b.z * a.z};
}

/// a a, which is symmetric as well.
template <class T>
SABO_HD constexpr Sym3<T> squared(const Sym3<T>& a) {
  const Vec3<T> x = a * Vec3<T>{a.xx, a.xy, a.xz};
  const Vec3<T> y = a * Vec3<T>{a.xy, a.yy, a.yz};
  const Vec3<T> z = a * Vec3<T>{a.xz, a.yz, a.zz};
  return {x.x, x.y, x.z, y.y, y.z, z.z};
}

template <class T>
SABO_HD constexpr Sym3<T> isotropic(T s) {
  return {s, T(0), T(0), s, T(0), s};
}

SABO_HD constexpr Sym3<float> in_single(const Sym3<double>& a) {
  return {float(a.xx), float(a.xy), float(a.xz), float(a.yy), float(a.yz), float(a.zz)};
}
SABO_HD constexpr Sym3<double> in_double(const Sym3<float>& a) {
  return {a.xx, a.xy, a.xz, a.yy, a.yz, a.zz};
}

}  // namespace sabo
