#pragma once

#include <optional>

#include "analysis/station_index.hpp"
#include "particles/particles.hpp"
#include "terrain/polyline.hpp"

namespace sabo {

/// State of the front along the path, in plan.
struct FrontRow {
  double position = 0;      ///< station on the path, m
  double displacement = 0;  ///< since the first row, m
  double velocity = 0;      ///< mean since the row before, m/s; 0 in the first
};

/// Front of the flow: mean station of the foremost 1 % of the mass along a path.
class Front {
 public:
  static constexpr double share = 0.01;

  /// The path needs two different vertices; its ends are continued straight.
  explicit Front(const Polyline& path) : index_(path) {}

  /// Row at `time` (s), later than that of the row before. Velocity is not smoothed beyond the mean
  /// over the interval. Without particles the front stays where it was.
  FrontRow update(double time, const Particles& particles);

  template <class Archive>
  void archive(Archive& a) {
    a(start_, last_time_, last_position_);
  }

 private:
  StationIndex index_;
  std::optional<double> start_;
  double last_time_ = 0;
  double last_position_ = 0;
};

}  // namespace sabo
