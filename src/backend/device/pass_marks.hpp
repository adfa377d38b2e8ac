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
    /// `name` must be a literal; `pairs` is the number of pairs that the pass visits.
    Clock(PassMarks& marks, std::string_view name, std::uint64_t pairs)
        : marks_(marks.with_room()), name_(name), pairs_(pairs), start_(marks.on_.now()) {}
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;
    ~Clock() { marks_.marks_.push_back({name_, pairs_, std::move(start_), marks_.on_.now()}); }

   private:
    PassMarks& marks_;
    std::string_view name_;
    std::uint64_t pairs_;
    Moment start_;
  };

  /// Both must outlive this object.
  PassMarks(const Executor& on, PassTimes& times) : on_(on), times_(times) {}

  /// Waits for the passes that were marked and adds up their times.
  void settle() { settle(marks_.size()); }

 private:
  struct Mark {
    std::string_view name;
    std::uint64_t pairs;
    Moment start, end;
  };

  /// The first ones.
  void settle(std::size_t count) {
    const auto end = marks_.begin() + static_cast<std::ptrdiff_t>(count);
    for (auto mark = marks_.begin(); mark != end; ++mark) {
      PassTime& pass = times_[mark->name];
      pass.seconds += on_.seconds_between(mark->start, mark->end);
      ++pass.calls;
      pass.pairs += mark->pairs;
    }
    marks_.erase(marks_.begin(), end);
  }

  /// Before too many marks wait, and outside of any pass; those of some steps ago are done.
  PassMarks& with_room() {
    if (marks_.size() > 256) settle(marks_.size() / 2);
    return *this;
  }

  const Executor& on_;
  PassTimes& times_;
  std::vector<Mark> marks_;
};

}  // namespace sabo
