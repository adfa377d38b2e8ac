#pragma once

#include <utility>

#include <cuda_runtime_api.h>

namespace sabo {

/// A place in the order of the work on the card: the card notes the time when it gets there. Where
/// the card has failed it is no place, and nothing is thrown: ends of passes are marked on the way
/// out of what failed.
class CardMoment {
 public:
  CardMoment() noexcept;
  CardMoment(CardMoment&& other) noexcept : event_(std::exchange(other.event_, nullptr)) {}
  CardMoment& operator=(CardMoment&& other) noexcept {
    std::swap(event_, other.event_);
    return *this;
  }
  ~CardMoment();

  /// Until the card has been there; from any thread. Throws RunError where it has failed.
  void wait() const;
  /// Waits until the card has been there. 0 where it has failed: the next pass says why.
  double seconds_since(const CardMoment& start) const;

 private:
  cudaEvent_t event_ = nullptr;  // of a pool, since to make one takes longer than to use it
};

}  // namespace sabo
