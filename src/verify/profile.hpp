#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "io/output/svg_chart.hpp"
#include "particles/particles.hpp"
#include "solver/stepper.hpp"

namespace sabo {

// Flows along x that depend on the height z alone, beside their exact profile u(z).

using Profile = std::function<double(double z)>;  // m -> m/s

/// Speed over height, of each particle.
inline ChartSeries profile_series(const std::string& name, const Particles& fluid) {
  std::vector<std::size_t> order(fluid.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return fluid.position[i].z; });
  ChartSeries series{name};
  for (const std::size_t i : order) {
    series.x.push_back(fluid.position[i].z);
    series.y.push_back(fluid.velocity[i].x);
  }
  return series;
}

/// Root mean square of the difference over that of the exact speed; of speeds over heights.
inline double profile_error(const ChartSeries& flow, const Profile& exact) {
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < flow.x.size(); ++k) {
    const double u = exact(flow.x[k]);
    difference += (flow.y[k] - u) * (flow.y[k] - u);
    size += u * u;
  }
  return std::sqrt(difference / size);
}
inline double profile_error(const Particles& fluid, const Profile& exact) {
  return profile_error(profile_series("", fluid), exact);
}

/// Markers of the exact profile between 0 and `height`.
inline ChartSeries exact_series(const std::string& name, const Profile& exact, double height) {
  constexpr int points = 24;
  ChartSeries series{name};
  for (int k = 0; k <= points; ++k) {
    series.x.push_back(height * k / points);
    series.y.push_back(exact(series.x.back()));
  }
  series.has_markers = true;
  series.has_line = false;
  return series;
}

/// Errors over spacings. The order is the slope of the straight line through them on logarithmic
/// axes, by least squares.
inline double order_of(const ChartSeries& errors) {
  const double count = static_cast<double>(errors.x.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < errors.x.size(); ++k) {
    const double log_x = std::log(errors.x[k]), log_y = std::log(errors.y[k]);
    x += log_x / count;
    y += log_y / count;
    xx += log_x * log_x / count;
    xy += log_x * log_y / count;
  }
  return (xy - x * y) / (xx - x * x);
}

/// Errors on logarithmic axes, beside a line of first order through the greatest of them.
inline LineChart error_chart(const std::string& title, std::vector<ChartSeries> errors) {
  LineChart chart{title, "spacing [m]", "relative L2 error"};
  chart.x_log = chart.y_log = true;
  ChartSeries first{"first order"};
  double most = 0;
  for (ChartSeries& series : errors) {
    series.has_markers = true;
    const auto [low, high] = std::ranges::minmax(series.x);
    most = std::max(most, std::ranges::max(series.y));
    first.x = {low, high};
    first.y = {most * low / high, most};
    chart.series.push_back(std::move(series));
  }
  chart.series.push_back(std::move(first));
  return chart;
}

}  // namespace sabo
