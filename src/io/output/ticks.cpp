#include "io/output/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace sabo {

double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / power * (1 + 1e-12);
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

std::string Ticks::label(double value) const {
  if (std::abs(value) < 1e-9 * step) value = 0;
  const double size = std::max(std::abs(first()), std::abs(last()));
  const bool is_plain = step >= 1e-4 && size < 1e7;
  const int decimals = static_cast<int>(std::max(0.0, std::ceil(-std::log10(step) - 1e-9)));
  std::string text = is_plain ? fmt::format("{:.{}f}", std::abs(value), decimals)
                              : fmt::format("{:.4g}", std::abs(value));
  return value < 0 ? "\u2212" + text : text;
}

Ticks ticks_over(double low, double high, int count) {
  if (low > high) std::swap(low, high);
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low < 1e-6 * size || high == low) {  // a flat line in the middle of the axis
    const double margin = size > 0 ? 0.5 * size : 0.5;
    low -= margin;
    high += margin;
  }
  Ticks ticks;
  // 1.5 so that the rounding down gives `count` intervals on average and not more than that.
  ticks.step = round_down((high - low) / count * 1.5);
  const double first = std::floor(low / ticks.step + 1e-9);
  const int intervals = static_cast<int>(std::ceil(high / ticks.step - 1e-9) - first);
  for (int k = 0; k <= intervals; ++k) ticks.values.push_back((first + k) * ticks.step);
  return ticks;
}

}  // namespace sabo
