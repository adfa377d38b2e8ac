#pragma once

#include <deque>

#include "base/error.hpp"
#include "math/vec3.hpp"

namespace sabo {

/// The greatest horizontal force on a structure, as a mean over a window of time that moves along.
/// A blow shorter than that moves no wall, and weakly compressible flows make such blows of their
/// own; the mean keeps the momentum of all of them.
class LoadPeak {
 public:
  /// `window` in s. Nothing happens before `start` (s).
  explicit LoadPeak(double window, double start = 0) : window_(window), samples_{{start, {}}} {}

  /// All that the structure has been given until `time` (s), N s. Times must not decrease.
  void add(double time, const Vec3d& impulse);

  double force() const { return force_; }  ///< N
  double time() const { return time_; }    ///< end of its window, s

  template <class Archive>
  void archive(Archive& a) {
    a(samples_, force_, time_);
    if (samples_.empty()) throw RunError("holds no samples of a load");
  }

 private:
  struct Sample {
    double time;
    Vec3d impulse;
  };

  double window_;
  std::deque<Sample> samples_;  ///< of the window, and the last one before it
  double force_ = 0;
  double time_ = 0;
};

}  // namespace sabo
