#pragma once

#include <cmath>

#include "base/host_device.hpp"

namespace sabo {

/// Papanastasiou's (1987) factor (1 - exp(-m gd)) / gd, s, which takes the place of 1/gd: m at
/// rest, 1/gd once m gd >> 1.
SABO_HD inline double exponential_rise(double rate, double m) {
  using std::expm1;
  const double x = m * rate;
  return x > 0 ? m * (-expm1(-x) / x) : m;
}

}  // namespace sabo
