#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "backend/pass_times.hpp"

namespace sabo {

/// Times passes without waiting for any: their ends are marked in the order of the work, and the
/// times between the marks are asked for later.
template <class Executor>
class PassMarks {
 public:
  using Moment = typename Executor::Moment;

  /// A pass over the scope of this object.
  class Clock {
   public:
    Clock(PassMarks& marks, const Executor& on, std::string_view name, std::uint64_t pairs)
        : marks_(marks), on_(on), name_(name), pairs_(pairs), start_(on.now()) {}
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;
    ~Clock() { marks_.marks_.push_back({name_, pairs_, std::move(start_), on_.now()}); }

   private:
    PassMarks& marks_;
    const Executor& on_;
    std::string_view name_;
    std::uint64_t pairs_;
    Moment start_;
  };

  /// Whether it is time to settle, before too many marks wait.
  bool is_long() const { return marks_.size() > 256; }

  /// Waits for the passes that were marked and adds up their times.
  void settle(const Executor& on, PassTimes& times) {
    for (const Mark& mark : marks_) {
      PassTime& pass = times[mark.name];
      pass.seconds += on.seconds_between(mark.start, mark.end);
      ++pass.calls;
      pass.pairs += mark.pairs;
    }
    marks_.clear();
  }

 private:
  struct Mark {
    std::string_view name;
    std::uint64_t pairs;
    Moment start, end;
  };
  std::vector<Mark> marks_;
};

}  // namespace sabo
