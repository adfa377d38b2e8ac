#include "bench/measurement.hpp"

#include <algorithm>
#include <utility>

namespace sabo {

double Samples::median() const {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double Samples::low() const { return *std::min_element(values.begin(), values.end()); }
double Samples::high() const { return *std::max_element(values.begin(), values.end()); }

Samples Samples::mapped(const std::function<double(double)>& f) const {
  Samples result;
  for (const double value : values) result.values.push_back(f(value));
  return result;
}

Measurement::Measurement(std::string name_, std::string unit_, const Samples& samples)
    : name(std::move(name_)),
      unit(std::move(unit_)),
      value(samples.median()),
      low(samples.low()),
      high(samples.high()),
      repeats(samples.values.size()) {}

}  // namespace sabo
