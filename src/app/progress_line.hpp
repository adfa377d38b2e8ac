#pragma once

#include <optional>
#include <string>

#include "run/simulation.hpp"

namespace sabo {

/// How fast a run goes, as a mean over its last 20 s or so of wall clock.
class Pace {
 public:
  void update(const RunProgress& progress);

  double steps_per_second() const { return wall_ > 0 ? steps_ / wall_ : 0; }
  /// Wall clock until the end, s; nothing until the run has moved.
  std::optional<double> seconds_left() const;

 private:
  bool has_begun_ = false;
  double last_wall_ = 0;   // of the last update, s
  double last_time_ = 0;   // simulated by then, s
  double last_steps_ = 0;  // made by then
  double time_left_ = 0;   // simulated, s
  // Sums over the past that decay with its age.
  double wall_ = 0;  // s
  double time_ = 0;  // simulated, s
  double steps_ = 0;
};

/// How a run stands, in at most `width` columns: share done, times, front, fastest speed, volumes,
/// pace and time step; what does not fit is left out from the end. `has_dam` says whether there is
/// anything to be trapped by.
std::string progress_text(const RunProgress& progress, const Pace& pace, bool has_dam, int width);

/// The same after a bar, if there is room for one.
std::string progress_bar(const RunProgress& progress, const Pace& pace, bool has_dam, int width);

}  // namespace sabo
