#pragma once

#include <cmath>

#include "base/host_device.hpp"

namespace sabo {

/// Three components of any arithmetic type. In two dimensions y is zero.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  SABO_HD constexpr Vec3& operator+=(const Vec3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  SABO_HD constexpr Vec3& operator-=(const Vec3& b) {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
  SABO_HD constexpr Vec3& operator*=(T s) {
    x *= s;
    y *= s;
    z *= s;
    return *this;
  }
  friend SABO_HD constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  friend SABO_HD constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  friend SABO_HD constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend SABO_HD constexpr Vec3 operator*(T s, Vec3 a) { return a *= s; }
  friend SABO_HD constexpr Vec3 operator*(Vec3 a, T s) { return a *= s; }
  friend SABO_HD constexpr bool operator==(const Vec3& a, const Vec3& b) = default;
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

SABO_HD constexpr Vec3f in_single(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }
SABO_HD constexpr Vec3d in_double(const Vec3f& v) { return {v.x, v.y, v.z}; }

template <class T>
SABO_HD constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
SABO_HD constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
SABO_HD T norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// The part of v at right angles to a normal of length one: along the surface it stands on.
template <class T>
SABO_HD constexpr Vec3<T> along(const Vec3<T>& v, const Vec3<T>& normal) {
  return v - dot(v, normal) * normal;
}

template <class T>
SABO_HD Vec3<T> normalised(const Vec3<T>& a) {
  return (T(1) / norm(a)) * a;
}

}  // namespace sabo
