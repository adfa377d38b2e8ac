#include "analysis/load_peak.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

void LoadPeak::add(double time, const Vec3d& impulse) {
  samples_.push_back({time, impulse});
  const double start = time - window_;
  while (samples_[1].time <= start) samples_.pop_front();
  const Sample &a = samples_[0], &b = samples_[1];
  const double share = b.time > a.time ? (start - a.time) / (b.time - a.time) : 0;
  // Nothing happens before the first sample.
  const Vec3d before = a.impulse + std::clamp(share, 0.0, 1.0) * (b.impulse - a.impulse);
  const Vec3d mean = (1 / window_) * (impulse - before);
  const double horizontal = std::hypot(mean.x, mean.y);
  if (horizontal <= force_) return;
  force_ = horizontal;
  time_ = time;
}

}  // namespace sabo
