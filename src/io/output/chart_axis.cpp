#include "io/output/chart_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/output/ticks.hpp"

namespace sabo {
namespace {

std::string raised(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

// Label of lead x 10^exponent.
std::string power_label(int lead, int exponent, bool is_plain) {
  if (is_plain || exponent == 0) return fmt::format("{:g}", lead * std::pow(10.0, exponent));
  const std::string power = exponent == 1 ? "10" : "10" + raised(exponent);
  return lead == 1 ? power : fmt::format("{}×{}", lead, power);
}

// Decades within which a double and all powers of ten near it keep their digits.
int decade(double exponent) { return static_cast<int>(std::clamp(exponent, -150.0, 150.0)); }

}  // namespace

bool ChartAxis::can_show(double value) const {
  return std::isfinite(value) && (!is_log || value > 0);
}

double ChartAxis::share(double value) const {
  if (is_log) {
    return (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low));
  }
  return (value - low) / (high - low);
}

ChartAxis linear_axis(double low, double high, int count) {
  const Ticks ticks = ticks_over(low, high, count);
  ChartAxis axis{false, ticks.first(), ticks.last(), {}, {}};
  for (double value : ticks.values) axis.ticks.push_back({value, ticks.label(value)});
  return axis;
}

ChartAxis log_axis(double low, double high, int count) {
  if (low > high) std::swap(low, high);
  // The margin lets a range end on a decade whatever the rounding of the logarithm.
  int first = decade(std::floor(std::log10(low) + 1e-9));
  const int last = decade(std::ceil(std::log10(high) - 1e-9));
  const int stride = std::max(1, (last - first + count - 1) / count);
  int steps = (last - first + stride - 1) / stride;
  if (steps == 0) {  // one value on a decade: in the middle of the axis
    --first;
    steps = 2;
  }
  ChartAxis axis{true, std::pow(10.0, first), std::pow(10.0, first + steps * stride), {}, {}};
  const bool is_plain = first >= -3 && first + steps * stride <= 4;
  const bool has_leads = stride == 1 && steps <= 2;
  for (int k = 0; k <= steps; ++k) {
    const int exponent = first + k * stride;
    axis.ticks.push_back({std::pow(10.0, exponent), power_label(1, exponent, is_plain)});
    if (k == steps || stride > 1) continue;
    for (int lead = 2; lead <= 9; ++lead) {
      const double value = lead * std::pow(10.0, exponent);
      if (has_leads && (lead == 2 || lead == 5)) {
        axis.ticks.push_back({value, power_label(lead, exponent, is_plain)});
      } else {
        axis.minor.push_back(value);
      }
    }
  }
  return axis;
}

}  // namespace sabo
