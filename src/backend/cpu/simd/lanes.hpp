#pragma once

#include <hwy/highway.h>

namespace sabo {
namespace HWY_NAMESPACE {  // another type for every instruction set this is compiled for

namespace hn = hwy::HWY_NAMESPACE;

/// A SIMD vector of floats, at most 16, that the formulas in src/physics take for a number.
struct Lanes {
  using Tag = hn::CappedTag<float, 16>;
  using Vector = hn::Vec<Tag>;
  static constexpr std::size_t count = HWY_LANES(float) < 16 ? HWY_LANES(float) : 16;

  Vector v;

  Lanes() : v(hn::Zero(Tag())) {}
  Lanes(Vector vector) : v(vector) {}  // NOLINT(google-explicit-constructor)
  explicit Lanes(float x) : v(hn::Set(Tag(), x)) {}

  Lanes& operator+=(const Lanes& b) { return *this = Lanes(hn::Add(v, b.v)); }
  Lanes& operator-=(const Lanes& b) { return *this = Lanes(hn::Sub(v, b.v)); }
  Lanes& operator*=(const Lanes& b) { return *this = Lanes(hn::Mul(v, b.v)); }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return hn::Add(a.v, b.v); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return hn::Sub(a.v, b.v); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return hn::Mul(a.v, b.v); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return hn::Div(a.v, b.v); }
  friend Lanes operator-(const Lanes& a) { return hn::Neg(a.v); }
  friend Lanes sqrt(const Lanes& a) { return hn::Sqrt(a.v); }
  friend Lanes round(const Lanes& a) { return hn::Round(a.v); }
  friend Lanes larger(const Lanes& a, const Lanes& b) { return hn::Max(a.v, b.v); }
  friend Lanes smaller(const Lanes& a, const Lanes& b) { return hn::Min(a.v, b.v); }
  /// 1 where a > 0, else 0.
  friend Lanes positive(const Lanes& a) {
    return hn::IfThenElseZero(hn::Gt(a.v, hn::Zero(Tag())), hn::Set(Tag(), 1.0f));
  }
  friend float sum(const Lanes& a) { return hn::GetLane(hn::SumOfLanes(Tag(), a.v)); }
};

}  // namespace HWY_NAMESPACE
}  // namespace sabo
