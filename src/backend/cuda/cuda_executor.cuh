#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "backend/cuda/device_array.cuh"

namespace sabo {

/// Threads of a block.
inline constexpr unsigned block_size = 256;

/// One thread for each i.
template <class F>
__global__ void __launch_bounds__(block_size)
    run_each(std::size_t count, const __grid_constant__ F f) {
  const std::size_t i = std::size_t{blockIdx.x} * block_size + threadIdx.x;
  if (i < count) f(i);
}

/// The sum over a block, in its first thread; always in the same order.
template <class Sum>
__device__ Sum joined_in_block(const Sum& mine) {
  __shared__ alignas(Sum) unsigned char memory[block_size * sizeof(Sum)];
  Sum* sums = reinterpret_cast<Sum*>(memory);
  sums[threadIdx.x] = mine;
  __syncthreads();
  for (unsigned half = block_size / 2; half > 0; half /= 2) {
    if (threadIdx.x < half) sums[threadIdx.x].join(sums[threadIdx.x + half]);
    __syncthreads();
  }
  return sums[0];
}

/// Blocks of a sum: enough to fill any card.
inline constexpr std::size_t most_partial_sums = 2048;

/// A partial sum for each block.
template <class Sum, class F>
__global__ void __launch_bounds__(block_size)
    sum_blocks(std::size_t count, const __grid_constant__ F f, Sum* partial) {
  const std::size_t stride = std::size_t{gridDim.x} * block_size;
  Sum mine;
  for (std::size_t i = std::size_t{blockIdx.x} * block_size + threadIdx.x; i < count; i += stride)
    f(i, mine);
  const Sum sum = joined_in_block(mine);
  if (threadIdx.x == 0) partial[blockIdx.x] = sum;
}

/// The sum of the partial sums, by one block.
template <class Sum>
__global__ void __launch_bounds__(block_size)
    sum_partial(std::size_t count, const Sum* partial, Sum* total) {
  Sum mine;
  for (std::size_t k = threadIdx.x; k < count; k += block_size) mine.join(partial[k]);
  const Sum sum = joined_in_block(mine);
  if (threadIdx.x == 0) *total = sum;
}

/// Runs loops on the card, one kernel each, in the order in which they are given. See HostExecutor
/// for what the members do. Sums have a fixed order and nothing is added up atomically: the same
/// bits in every run on the same kind of card.
class CudaExecutor {
 public:
  template <class T>
  using Array = DeviceArray<T>;

  template <class F>
  void for_each(std::size_t count, const F& f) const {
    static_assert(std::is_trivially_copyable_v<F> && sizeof(F) < 4000);
    if (count == 0) return;
    run_each<<<blocks(count), block_size>>>(count, f);
    check_cuda(cudaGetLastError(), "kernel launch");
  }

  template <class Sum, class F>
  Sum reduce(std::size_t count, const F& f) const {
    static_assert(std::is_trivially_copyable_v<F> && sizeof(F) < 4000);
    Sum total;
    if (count == 0) return total;
    DeviceArray<Sum> partial, sum;
    const auto sums = std::min<std::size_t>(blocks(count), most_partial_sums);
    partial.resize(sums);
    sum.resize(1);
    sum_blocks<Sum><<<static_cast<unsigned>(sums), block_size>>>(count, f, partial.data());
    check_cuda(cudaGetLastError(), "kernel launch");
    sum_partial<Sum><<<1, block_size>>>(partial.size(), partial.data(), sum.data());
    check_cuda(cudaGetLastError(), "kernel launch");
    fetch(sum.data(), 1, &total);
    return total;
  }

  template <class T>
  void zero(DeviceArray<T>& array, std::size_t count) const {
    array.resize(count);
    if (count > 0) check_cuda(cudaMemsetAsync(array.data(), 0, count * sizeof(T)), "cudaMemset");
  }
  template <class T>
  void reserve(DeviceArray<T>& array, std::size_t count) const {
    array.resize(count);
  }
  template <class T>
  void release(DeviceArray<T>& array) const {
    array.resize(0);
  }

  template <class T>
  void upload(const std::vector<T>& from, DeviceArray<T>& to) const {
    to.resize(from.size());
    move(from.data(), from.size(), to.data(), cudaMemcpyHostToDevice);
    wait();  // `from` may be gone at once, and not every card has staged it by now
  }
  template <class T>
  void download(const DeviceArray<T>& from, std::vector<T>& to) const {
    to.resize(from.size());
    fetch(from.data(), from.size(), to.data());
  }
  template <class T>
  void copy(const DeviceArray<T>& from, DeviceArray<T>& to) const {
    to.resize(from.size());
    move(from.data(), from.size(), to.data(), cudaMemcpyDeviceToDevice);
  }
  template <class T>
  T last(const DeviceArray<T>& array) const {
    T value;
    fetch(array.data() + array.size() - 1, 1, &value);
    return value;
  }

  void sort(DeviceArray<std::uint64_t>& keys, DeviceArray<std::uint32_t>& values, int bits) const;
  void scan(DeviceArray<std::uint64_t>& values) const;

  /// What has failed is said by the next call that can throw.
  void wait() const noexcept { cudaStreamSynchronize(nullptr); }

 private:
  static unsigned blocks(std::size_t count) {
    return static_cast<unsigned>((count + block_size - 1) / block_size);
  }
  template <class T>
  static void move(const T* from, std::size_t count, T* to, cudaMemcpyKind kind) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count > 0) check_cuda(cudaMemcpyAsync(to, from, count * sizeof(T), kind), "cudaMemcpy");
  }
  template <class T>
  static void fetch(const T* from, std::size_t count, T* to) {
    move(from, count, to, cudaMemcpyDeviceToHost);
    check_cuda(cudaStreamSynchronize(nullptr), "pass");
  }
};

}  // namespace sabo
