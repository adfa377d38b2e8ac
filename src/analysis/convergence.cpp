#include "analysis/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace sabo {
namespace {

// Changes below this share of the values are rounding.
constexpr double rounding = 1e-9;
// Safety factors of Roache (1994).
constexpr double factor_of_three = 1.25;
constexpr double factor_of_two = 3;

/// Rate at which differences grow from the fine to the coarse pair, by an order p > 0:
/// (h3^p - h2^p) / (h2^p - h1^p) with a = ln(h2/h1), b = ln(h3/h2). It rises with p from b/a at
/// p = 0: the derivative of its logarithm times p is x/(1 - e^-x) of x = bp, at least 1, less
/// y/(e^y - 1) of y = ap, at most 1.
double growth(double a, double b, double p) {
  return std::exp(a * p) * std::expm1(b * p) / std::expm1(a * p);
}

/// The order at which differences grow at the rate; none if it would not be positive.
std::optional<double> order_of(double rate, double a, double b) {
  if (!(rate > b / a * (1 + rounding))) return std::nullopt;
  double low = 0, high = 1;
  constexpr double greatest = 64;
  while (high < greatest && growth(a, b, high) < rate) high *= 2;
  for (int k = 0; k < 200 && high - low > 1e-13 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (growth(a, b, middle) < rate ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Limit and uncertainty from the two finest samples and an order.
void extrapolate(const GridSample& fine, const GridSample& next, double safety,
                 GridConvergence& result) {
  const double ratio = std::log(next.spacing / fine.spacing);
  const double change = fine.value - next.value;
  result.extrapolated = fine.value + change / std::expm1(result.order * ratio);
  const double trusted = std::min(result.order, greatest_trusted_order);
  result.uncertainty = safety * std::abs(change) / std::expm1(trusted * ratio);
}

}  // namespace

GridConvergence grid_convergence(std::span<const GridSample> samples) {
  GridConvergence result;
  if (samples.empty()) return result;
  std::vector<GridSample> s(samples.begin(), samples.end());
  std::sort(s.begin(), s.end(),
            [](const GridSample& l, const GridSample& r) { return l.spacing < r.spacing; });
  const auto [low, high] = std::minmax_element(
      s.begin(), s.end(),
      [](const GridSample& l, const GridSample& r) { return l.value < r.value; });
  result.lowest = low->value;
  result.highest = high->value;
  if (s.size() == 1) return result;

  const double size = std::max(std::abs(result.lowest), std::abs(result.highest));
  if (result.highest - result.lowest <= rounding * size) {
    result.kind = Convergence::unchanged;
    result.extrapolated = s.front().value;
    return result;
  }
  if (s.size() == 2) {
    result.kind = Convergence::first_order;
    result.order = 1;
    extrapolate(s[0], s[1], factor_of_two, result);
    return result;
  }
  result.kind = Convergence::no_order;
  const double fine_change = s[1].value - s[0].value;
  const double coarse_change = s[2].value - s[1].value;
  if (std::abs(fine_change) <= rounding * size || fine_change * coarse_change <= 0) return result;
  const auto order = order_of(coarse_change / fine_change, std::log(s[1].spacing / s[0].spacing),
                              std::log(s[2].spacing / s[1].spacing));
  if (!order) return result;
  result.kind = Convergence::monotone;
  result.order = *order;
  extrapolate(s[0], s[1], factor_of_three, result);
  return result;
}

Scatter scatter_of(std::span<const double> values) {
  Scatter scatter;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) scatter.mean += value / count;
  if (values.size() < 2) return scatter;
  double sum = 0;
  for (const double value : values) sum += (value - scatter.mean) * (value - scatter.mean);
  scatter.deviation = std::sqrt(sum / (count - 1));
  return scatter;
}

}  // namespace sabo
