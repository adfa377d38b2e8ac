#include <utility>
#include <vector>

#include "backend/cuda/card_moment.hpp"
#include "backend/cuda/check_cuda.hpp"

namespace sabo {
namespace {

/// Events that nobody holds. Kept to the end of the program, as sum_space().
std::vector<cudaEvent_t>& idle_events() {
  static auto* const events = new std::vector<cudaEvent_t>;
  return *events;
}

}  // namespace

CardMoment::CardMoment() noexcept {
  std::vector<cudaEvent_t>& idle = idle_events();
  if (!idle.empty()) {
    event_ = idle.back();
    idle.pop_back();
  } else if (cudaEventCreate(&event_) != cudaSuccess) {
    event_ = nullptr;
  }
  if (event_ && cudaEventRecord(event_) == cudaSuccess) return;
  if (event_) idle.push_back(std::exchange(event_, nullptr));
  cudaGetLastError();  // what is wrong is for the next pass to find
}

CardMoment::~CardMoment() {
  if (event_) idle_events().push_back(event_);
}

void CardMoment::wait() const {
  check_cuda(event_ ? cudaEventSynchronize(event_) : cudaStreamSynchronize(nullptr), "copy");
}

double CardMoment::seconds_since(const CardMoment& start) const {
  float milliseconds = 0;
  if (!event_ || !start.event_ || cudaEventSynchronize(event_) != cudaSuccess ||
      cudaEventElapsedTime(&milliseconds, start.event_, event_) != cudaSuccess)
    return 0;
  return 1e-3 * milliseconds;
}

}  // namespace sabo
