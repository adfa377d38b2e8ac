#include "verify/water.hpp"

#include <algorithm>
#include <limits>

namespace sabo {

MaterialCase water() {
  MaterialCase material;
  material.density = 1000;
  material.law = Newtonian{1e-3};
  return material;
}

NumericsCase water_numerics(const VerifySettings& settings, double spacing, double fastest) {
  NumericsCase numerics = settings.numerics();
  numerics.spacing = spacing;
  numerics.artificial_viscosity = water_artificial_viscosity;
  if (settings.method == Method::paper) numerics.reference_speed = fastest;
  return numerics;
}

void run_until(Stepper& stepper, double end, const std::function<void(double time)>& after_step,
               const std::function<void(double share)>& on_progress) {
  constexpr std::size_t interval = 16;  // steps between reports
  while (stepper.time() < end) {
    stepper.step(end - stepper.time());
    after_step(stepper.time());
    if (stepper.steps() % interval == 0) on_progress(stepper.time() / end);
  }
  on_progress(1);
}

void TimeIntegral::set(double time, double integral) {
  time_.push_back(time);
  integral_.push_back(integral);
}

void TimeIntegral::go_on(double time, double value) {
  set(time, integral_.back() + value * (time - time_.back()));
}

double TimeIntegral::at(double time) const {
  const auto after = std::upper_bound(time_.begin(), time_.end(), time);
  if (after == time_.begin()) return integral_.front();
  if (after == time_.end()) return integral_.back();
  const auto k = static_cast<std::size_t>(after - time_.begin());
  const double part = (time - time_[k - 1]) / (time_[k] - time_[k - 1]);
  return integral_[k - 1] + part * (integral_[k] - integral_[k - 1]);
}

double TimeIntegral::around(double time, double window) const {
  return mean(time - 0.5 * window, time + 0.5 * window);
}

TimeIntegral::Peak TimeIntegral::peak(double window, double from, double to) const {
  Peak peak{-std::numeric_limits<double>::infinity(), from};
  const double step = 0.1 * window;
  for (double time = from; time <= to; time += step)
    if (const double value = around(time, window); value > peak.value) peak = {value, time};
  return peak;
}

double TimeIntegral::rises_above(double level, double window) const {
  for (const double time : time_)
    if (time > window && around(time, window) > level) return time;
  return std::numeric_limits<double>::quiet_NaN();
}

ChartSeries TimeIntegral::series(std::string name, double step, double end) const {
  ChartSeries series{std::move(name)};
  for (double time = 0.5 * step; time < end; time += step) {
    series.x.push_back(time);
    series.y.push_back(around(time, step));
  }
  return series;
}

ChartSeries measured_series(std::string name, double start, double step,
                            const std::vector<double>& values) {
  ChartSeries series{std::move(name)};
  for (std::size_t k = 0; k < values.size(); ++k) {
    series.x.push_back(start + step * static_cast<double>(k));
    series.y.push_back(values[k]);
  }
  series.has_markers = true;
  series.has_line = false;
  return series;
}

}  // namespace sabo
