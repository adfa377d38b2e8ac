#include "backend/cuda/cuda_executor.cuh"

namespace sabo {

/// Kept to the end of the program: a card may be gone before the last destructor runs.
const SumSpace& sum_space() {
  static const SumSpace space = [] {
    SumSpace made{};
    made.partial = allocate_on_card(most_partial_sums * SumSpace::largest);
    made.blocks_done = static_cast<unsigned*>(allocate_on_card(sizeof(unsigned)));
    check_cuda(cudaMemset(made.blocks_done, 0, sizeof(unsigned)), "cudaMemset");
    check_cuda(cudaMallocHost(&made.total, SumSpace::largest), "cudaMallocHost");
    return made;
  }();
  return space;
}

}  // namespace sabo
