#pragma once

#include <functional>
#include <future>
#include <system_error>

namespace sabo {

/// Work beside that of the caller, one piece at a time in a thread of its own.
class Background {
 public:
  Background() = default;
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits; what the last piece threw is lost then.
  ~Background() = default;

  /// Settles the piece before, then starts this one; does it at once where there is no thread to be
  /// had. What it works on must stay as it is until the next settle() or start().
  void start(const std::function<void()>& work) {
    settle();
    try {
      running_ = std::async(std::launch::async, work);
    } catch (const std::system_error&) {
      work();
    }
  }

  /// Waits for what was started; throws what that has thrown, once.
  void settle() {
    if (running_.valid()) running_.get();
  }

 private:
  std::future<void> running_;
};

}  // namespace sabo
