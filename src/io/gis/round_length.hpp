#pragma once

#include <cmath>

namespace sabo {

/// The number of the series 1, 2, 3, 5, 10, 20, ... that is nearest, in ratio, to a positive
/// length.
inline double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  const auto distance = [&](double candidate) { return std::abs(std::log(candidate / length)); };
  double best = power;
  for (const double digit : {2.0, 3.0, 5.0, 10.0}) {
    if (distance(digit * power) < distance(best)) best = digit * power;
  }
  return best;
}

}  // namespace sabo
