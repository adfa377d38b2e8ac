#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>

namespace sabo::test {

/// Work in the order in which it is asked for, done when something waits for it and not before: as
/// late as the work of a card may be. Members may be called from any thread.
class LateStream {
 public:
  /// How much work there was before.
  using Place = std::uint64_t;

  void add(std::function<void()> work);
  /// After all work that was asked for so far.
  Place place() const;
  void wait_for(Place place);
  void wait_for_all() { wait_for(place()); }

 private:
  mutable std::mutex asking_, working_;
  std::deque<std::function<void()>> work_;
  Place asked_ = 0, done_ = 0;
};

/// That of all arrays and executors. Kept to the end of the program, as what is on a card.
LateStream& late_stream();

}  // namespace sabo::test
