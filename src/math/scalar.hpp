#pragma once

#include "base/host_device.hpp"

namespace sabo {

// Branch-free choices for formulas that run on one number or on a SIMD vector of them: vector types
// bring their own overloads.

template <class T>
SABO_HD constexpr T larger(T a, T b) {
  return a > b ? a : b;
}

template <class T>
SABO_HD constexpr T smaller(T a, T b) {
  return a < b ? a : b;
}

}  // namespace sabo
