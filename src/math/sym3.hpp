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

template <class T>
SABO_HD constexpr Sym3<T> isotropic(T s) {
  return {s, T(0), T(0), s, T(0), s};
}

}  // namespace sabo
