#include "case/hydrograph.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {
namespace {

/// Number of the last row that is not after t; the first row for earlier times.
std::size_t row_before(const std::vector<double>& time, double t) {
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  return after == time.begin() ? 0 : static_cast<std::size_t>(after - time.begin()) - 1;
}

/// Straight between rows (which increase in t), constant outside of them.
double between(double t, double t0, double y0, double t1, double y1) {
  if (!(t > t0)) return y0;
  return t >= t1 ? y1 : y0 + (y1 - y0) * ((t - t0) / (t1 - t0));
}

double discharge_of(const Surge& surge, double t) {
  if (t < surge.start || t > surge.end) return 0;
  if (t == surge.peak_time) return surge.peak_discharge;
  return t < surge.peak_time
             ? surge.peak_discharge * (t - surge.start) / (surge.peak_time - surge.start)
             : surge.peak_discharge * (surge.end - t) / (surge.end - surge.peak_time);
}

/// The next number on the other side of a jump.
double just_before(double t) { return std::nextafter(t, t - 1); }
double just_after(double t) { return std::nextafter(t, t + 1); }

}  // namespace

double Hydrograph::discharge_at(double t) const {
  if (time.empty() || t < time.front() || t > time.back()) return 0;
  const std::size_t k = row_before(time, t);
  if (k + 1 == time.size()) return discharge[k];
  return between(t, time[k], discharge[k], time[k + 1], discharge[k + 1]);
}

double Hydrograph::volume_until(double t) const {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < time.size() && time[k] < t; ++k) {
    const double last = std::min(t, time[k + 1]);
    const double at_last = between(last, time[k], discharge[k], time[k + 1], discharge[k + 1]);
    sum += 0.5 * (discharge[k] + at_last) * (last - time[k]);
  }
  return sum;
}

double Hydrograph::volume() const { return time.empty() ? 0 : volume_until(time.back()); }

double Hydrograph::speed_at(double t) const {
  const std::size_t here = row_before(time, t);
  std::size_t before = here;
  while (before > 0 && !(discharge[before] > 0)) --before;
  std::size_t after = time[here] < t || !(discharge[here] > 0) ? here + 1 : here;
  while (after < time.size() && !(discharge[after] > 0)) ++after;
  if (after == time.size()) return speed[before];
  if (!(discharge[before] > 0) || t < time[before]) return speed[after];
  return between(t, time[before], speed[before], time[after], speed[after]);
}

std::size_t Hydrograph::peak() const {
  return static_cast<std::size_t>(std::max_element(discharge.begin(), discharge.end()) -
                                  discharge.begin());
}

double Hydrograph::end() const {
  std::size_t last = time.size();
  while (last > 0 && !(discharge[last - 1] > 0)) --last;
  if (last == 0) return time.empty() ? 0 : time.front();
  return time[std::min(last, time.size() - 1)];
}

Hydrograph hydrograph_of(const std::vector<Surge>& surges) {
  Hydrograph sum;
  for (const Surge& surge : surges) {
    sum.time.insert(sum.time.end(), {surge.start, surge.peak_time, surge.end});
    // A surge without a rise, or without a fall, jumps.
    if (surge.peak_time == surge.start) sum.time.push_back(just_before(surge.start));
    if (surge.peak_time == surge.end) sum.time.push_back(just_after(surge.end));
  }
  std::sort(sum.time.begin(), sum.time.end());
  sum.time.erase(std::unique(sum.time.begin(), sum.time.end()), sum.time.end());
  for (const double t : sum.time) {
    double discharge = 0;
    for (const Surge& surge : surges) discharge += discharge_of(surge, t);
    sum.discharge.push_back(discharge);
  }
  return sum;
}

}  // namespace sabo
