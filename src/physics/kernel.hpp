#pragma once

#include <numbers>

#include "base/host_device.hpp"
#include "math/scalar.hpp"

namespace sabo {

/// Wendland C2 kernel, W = a_D (1 - q/2)^4 (2q + 1) for q = r/h <= 2 (paper Eq. 4; Wendland 1995).
template <class T>
struct WendlandC2 {
  T h;      ///< smoothing length, m; the support ends at 2h
  T alpha;  ///< a_D: 7/(4 pi h^2) in two dimensions, 21/(16 pi h^3) in three

  SABO_HD static constexpr WendlandC2 make(double smoothing_length, int dimension) {
    constexpr double pi = std::numbers::pi;
    const double h2 = smoothing_length * smoothing_length;
    const double a = dimension == 2 ? 7 / (4 * pi * h2) : 21 / (16 * pi * h2 * smoothing_length);
    return {T(smoothing_length), T(a)};
  }

  SABO_HD constexpr T radius() const { return T(2) * h; }

  /// W(r), 1/m^D.
  SABO_HD constexpr T value(T r) const {
    const T q = r / h;
    const T t = larger(T(1) - q / T(2), T(0));
    return alpha * t * t * t * t * (T(2) * q + T(1));
  }

  /// F in grad_i W_ij = F x_ij, 1/m^(D+2); never positive. dW/dr = -5 a_D q (1 - q/2)^3 / h, so
  /// the division by r cancels and F is regular at r = 0.
  SABO_HD constexpr T gradient_factor(T r) const {
    const T half = T(0.5) / h;
    const T t = larger(T(1) - r * half, T(0));
    return T(-20) * alpha * half * half * (t * t * t);
  }
};

}  // namespace sabo
