#include <algorithm>

#include "backend/cuda/check_cuda.hpp"
#include "backend/cuda/cuda_executor.cuh"
#include "backend/cuda/graphics_card.hpp"

// What the card does at most: what a benchmark compares with.

namespace sabo {
namespace {

constexpr int repeats = 10;

struct CopyQuads {
  const float4* from;
  float4* to;
  __device__ void operator()(std::size_t i) const { to[i] = from[i]; }
};

/// Independent chains x -> a x + b, which settle at b / (1 - a): no overflow, no denormals.
struct MultiplyAdd {
  static constexpr int chains = 8;
  static constexpr int rounds = 4096;
  float factor;  // not known when it is compiled
  float* sums;
  __device__ void operator()(std::size_t i) const {
    float x[chains];
    for (int c = 0; c < chains; ++c) x[c] = static_cast<float>(i + c);
    for (int round = 0; round < rounds; ++round)
      for (int c = 0; c < chains; ++c) x[c] = fmaf(x[c], factor, 1 - factor);
    float sum = 0;
    for (int c = 0; c < chains; ++c) sum += x[c];
    sums[i] = sum;
  }
};

/// Seconds of one of several runs, after one that does not count.
template <class F>
double seconds_of(std::size_t count, const F& f) {
  const CudaExecutor on;
  cudaEvent_t start, end;
  check_cuda(cudaEventCreate(&start), "cudaEventCreate");
  check_cuda(cudaEventCreate(&end), "cudaEventCreate");
  on.for_each(count, f);
  check_cuda(cudaEventRecord(start), "cudaEventRecord");
  for (int k = 0; k < repeats; ++k) on.for_each(count, f);
  check_cuda(cudaEventRecord(end), "cudaEventRecord");
  check_cuda(cudaEventSynchronize(end), "cudaEventSynchronize");
  float milliseconds = 0;
  check_cuda(cudaEventElapsedTime(&milliseconds, start, end), "cudaEventElapsedTime");
  cudaEventDestroy(start);
  cudaEventDestroy(end);
  return 1e-3 * milliseconds / repeats;
}

}  // namespace

double card_bandwidth() {
  // Far more than the caches hold.
  const double bytes = std::min(1e9, graphics_card().free_memory / 4);
  const auto count = static_cast<std::size_t>(bytes / sizeof(float4));
  DeviceArray<float4> from, to;
  CudaExecutor().zero(from, count);
  to.resize(count);
  const double moved = 2.0 * static_cast<double>(count) * sizeof(float4);
  return moved / seconds_of(count, CopyQuads{from.data(), to.data()});
}

double card_peak() {
  constexpr std::size_t threads = std::size_t{1} << 20;
  DeviceArray<float> sums;
  sums.resize(threads);
  const double flops = 2.0 * MultiplyAdd::chains * MultiplyAdd::rounds * threads;
  return flops / seconds_of(threads, MultiplyAdd{0.5f, sums.data()});
}

}  // namespace sabo
