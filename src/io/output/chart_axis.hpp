#pragma once

#include <string>
#include <vector>

namespace sabo {

struct AxisTick {
  double value = 0;
  std::string label;
};

/// One axis of a chart, linear or with logarithms to base 10.
struct ChartAxis {
  bool is_log = false;
  double low = 0;  ///< first tick
  double high = 1;
  std::vector<AxisTick> ticks;
  std::vector<double> minor;  ///< places for lines between the ticks, without labels

  /// Whether a value has a place on the axis: finite, and positive where it is logarithmic.
  bool can_show(double value) const;
  /// 0 at the first tick, 1 at the last; outside [0, 1] beyond them.
  double share(double value) const;
};

/// Ticks of ticks_over() for any finite range.
ChartAxis linear_axis(double low, double high, int count);

/// Whole decades from at or below `low` to at or above `high` (both > 0), every one or, of more
/// than `count`, every second, third ... one. Up to two decades have ticks at 2 and 5 too. Labels
/// are plain from 0.001 to 10000 and powers of ten beyond.
ChartAxis log_axis(double low, double high, int count);

}  // namespace sabo
