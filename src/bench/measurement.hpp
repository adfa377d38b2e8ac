#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sabo {

/// Repeated values of one quantity.
struct Samples {
  std::vector<double> values;

  double median() const;
  double low() const;
  double high() const;
  /// Each value through f, e.g. from seconds to a rate.
  Samples mapped(const std::function<double(double)>& f) const;
};

/// A result: the median of its repetitions, and how far they spread.
struct Measurement {
  std::string name;  ///< "part/what/quantity"; the same in every version, so that files compare
  std::string unit;
  double value = 0;  ///< median
  double low = 0;    ///< least of the repetitions
  double high = 0;   ///< greatest of them
  std::size_t repeats = 0;

  Measurement() = default;
  Measurement(std::string name, std::string unit, const Samples& samples);
};

}  // namespace sabo
