#include "support/late_stream.hpp"

#include <utility>

namespace sabo::test {

void LateStream::add(std::function<void()> work) {
  const std::lock_guard lock(asking_);
  work_.push_back(std::move(work));
  ++asked_;
}

LateStream::Place LateStream::place() const {
  const std::lock_guard lock(asking_);
  return asked_;
}

void LateStream::wait_for(Place place) {
  const std::lock_guard in_order(working_);
  while (done_ < place) {
    std::function<void()> next;
    {
      const std::lock_guard lock(asking_);
      next = std::move(work_.front());
      work_.pop_front();
    }
    ++done_;
    next();
  }
}

LateStream& late_stream() {
  static auto* const stream = new LateStream;
  return *stream;
}

}  // namespace sabo::test
