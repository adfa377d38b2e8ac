#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sabo {

/// What one pass over the particles has taken since the start.
struct PassTime {
  std::string name;
  double seconds = 0;       ///< wall time
  std::uint64_t calls = 0;  ///< how often it ran
  std::uint64_t pairs = 0;  ///< pairs it visited; 0 for a pass over single particles

  template <class Archive>
  void archive(Archive& a) {
    a(name, seconds, calls, pairs);
  }
};

/// Time by pass. Passes come in the order of their first call and do not overlap, so that they sum
/// up to the time of the steps.
class PassTimes {
 public:
  const std::vector<PassTime>& passes() const { return passes_; }

  /// The entry of a pass, made at its first call.
  PassTime& operator[](std::string_view name) {
    const auto found = std::find_if(passes_.begin(), passes_.end(),
                                    [&](const PassTime& pass) { return pass.name == name; });
    if (found != passes_.end()) return *found;
    passes_.push_back({std::string(name)});
    return passes_.back();
  }

  /// Sum over all passes, s.
  double seconds() const {
    double sum = 0;
    for (const PassTime& pass : passes_) sum += pass.seconds;
    return sum;
  }

  void clear() { passes_.clear(); }

  template <class Archive>
  void archive(Archive& a) {
    a(passes_);
  }

 private:
  std::vector<PassTime> passes_;
};

/// Adds the time of its scope to a pass: one line at the head of a pass, outside of parallel
/// regions and of other clocks. Costs about a tenth of a microsecond.
class PassClock {
 public:
  /// `name` must be a literal; `pairs` is the number of pairs that the pass visits.
  PassClock(PassTimes& times, std::string_view name, std::uint64_t pairs = 0)
      : times_(times), name_(name), pairs_(pairs) {}
  PassClock(const PassClock&) = delete;
  PassClock& operator=(const PassClock&) = delete;
  ~PassClock() {
    const std::chrono::duration<double> time = Clock::now() - start_;
    PassTime& pass = times_[name_];
    pass.seconds += time.count();
    ++pass.calls;
    pass.pairs += pairs_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  PassTimes& times_;
  std::string_view name_;
  std::uint64_t pairs_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace sabo
