#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "backend/cuda/card_moment.hpp"
#include "backend/cuda/device_array.cuh"
#include "backend/device/pair_rows.hpp"
#include "backend/store_sum.hpp"

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

/// A partial sum for each block; the block that ends last joins them, always in the same order, and
/// hands the sum on: then(sum).
template <class Sum, class F, class Then>
__global__ void __launch_bounds__(block_size)
    sum_all(std::size_t count, const __grid_constant__ F f, const __grid_constant__ Then then,
            Sum* partial, unsigned* blocks_done) {
  const std::size_t stride = std::size_t{gridDim.x} * block_size;
  Sum mine;
  for (std::size_t i = std::size_t{blockIdx.x} * block_size + threadIdx.x; i < count; i += stride)
    f(i, mine);
  const Sum sum = joined_in_block(mine);
  __shared__ bool is_last;
  if (threadIdx.x == 0) {
    partial[blockIdx.x] = sum;
    __threadfence();  // the sum is there before it counts as done
    is_last = atomicAdd(blocks_done, 1u) == gridDim.x - 1;
  }
  __syncthreads();
  if (!is_last) return;
  __threadfence();
  Sum all;
  for (unsigned k = threadIdx.x; k < gridDim.x; k += block_size) all.join(partial[k]);
  const Sum joined = joined_in_block(all);
  if (threadIdx.x != 0) return;
  *blocks_done = 0;
  then(joined);
}

/// The same words of the thread `away` threads further in the warp.
template <class T>
__device__ T further(const T& mine, unsigned away) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(unsigned) == 0);
  constexpr std::size_t words = sizeof(T) / sizeof(unsigned);
  unsigned word[words];
  std::memcpy(word, &mine, sizeof(T));
  for (std::size_t w = 0; w < words; ++w) word[w] = __shfl_down_sync(~0u, word[w], away);
  T other;
  std::memcpy(&other, word, sizeof(T));
  return other;
}

/// Sums over the pairs of one row by `lanes` threads side by side, in the first of them. All
/// threads of a warp come here, those without a row as well.
template <unsigned lanes, class Sweep>
__device__ auto sums_of_row(std::size_t row, std::size_t count, const Sweep& sweep) {
  using Sums = decltype(sweep.sums_of(row, RowShare{}));
  Sums sums;
  if (row < count) sums = sweep.sums_of(row, {threadIdx.x % lanes, lanes});
  for (unsigned away = lanes / 2; away > 0; away /= 2) sums.join(further(sums, away));
  return sums;
}

/// A row of pairs for every `lanes` threads.
template <unsigned lanes, class Sweep>
__global__ void __launch_bounds__(block_size)
    sweep_rows(std::size_t count, const __grid_constant__ Sweep sweep) {
  const std::size_t row = (std::size_t{blockIdx.x} * block_size + threadIdx.x) / lanes;
  const auto sums = sums_of_row<lanes>(row, count, sweep);
  if (row < count && threadIdx.x % lanes == 0) sweep.finish(row, sums);
}

/// A sweep over pairs as something that is summed up; `i` counts threads.
template <unsigned lanes, class Sweep>
struct SumOverRows {
  std::size_t rows;
  Sweep sweep;
  template <class Sum>
  __device__ void operator()(std::size_t i, Sum& sum) const {
    const std::size_t row = i / lanes;
    const auto sums = sums_of_row<lanes>(row, rows, sweep);
    if (row < rows && i % lanes == 0) sweep.finish(row, sums, sum);
  }
};

/// Calls f.operator()<lanes>() with as many threads for a row as it takes to keep a card busy;
/// depends on the number of rows alone, as then do the bits.
template <unsigned lanes = 1, class F>
void with_lanes(std::size_t rows, const F& f) {
  constexpr std::size_t busy = 150'000;  // threads
  if constexpr (lanes < 32)
    if (lanes * rows < busy) return with_lanes<2 * lanes>(rows, f);
  f.template operator()<lanes>();
}

/// Where sums are added up, one at a time: all run on one stream.
struct SumSpace {
  static constexpr std::size_t largest = 128;  ///< bytes of a sum
  void* partial;
  unsigned* blocks_done;
  void* total;  ///< on the host, in sight of the card: no copy has to be asked for
};
const SumSpace& sum_space();

/// Where code that is written once for hosts and cards has its arrays and runs its loops: here in
/// the memory of the card, one kernel for each loop, in the order in which they are given. Values
/// that are returned, vectors, and memory of the host that is given back wait for the card; loops
/// do not. Sums have a fixed order and nothing is added up atomically: the same bits in every run
/// on the same kind of card.
///
/// Loop bodies are structs of plain values and pointers whose operator() is SABO_HD. They run when
/// the card gets to them: what they point to is the card's.
class CudaExecutor {
 public:
  /// Resized, it keeps its values if at all by chance; freed, it is there for the work that was
  /// asked for before.
  template <class T>
  using Array = DeviceArray<T>;
  /// On the host, where copies to it are made beside other work.
  template <class T>
  using StagingArray = PageLockedArray<T>;

  /// f(i) for i in [0, count), in no order; f writes to i alone.
  template <class F>
  void for_each(std::size_t count, const F& f) const {
    static_assert(std::is_trivially_copyable_v<F> && sizeof(F) < 4000);
    if (count == 0) return;
    run_each<<<blocks(count), block_size>>>(count, f);
    check_cuda(cudaGetLastError(), "kernel launch");
  }

  /// Joins what f(i, sum) adds, in an order that depends on `count` alone.
  template <class Sum, class F>
  Sum reduce(std::size_t count, const F& f) const {
    Sum total;
    if (count == 0) return total;
    void* seen = sum_space().total;
    start_sum<Sum>(count, f, StoreSum<Sum>{static_cast<Sum*>(seen)});
    wait("pass");
    std::memcpy(static_cast<void*>(&total), seen, sizeof(Sum));
    return total;
  }

  /// The same without a wait: then(sum), once all of f is done, so that it may write what that
  /// reads; the work after it can see what it does.
  template <class Sum, class F, class Then>
  void sum_up(std::size_t count, const F& f, const Then& then) const {
    start_sum<Sum>(count, f, then);
  }

  /// A sweep over the pairs of each i in [0, count); see backend/device/pair_rows.hpp.
  template <class Sweep>
  void sweep(std::size_t count, const Sweep& sweep) const {
    static_assert(std::is_trivially_copyable_v<Sweep> && sizeof(Sweep) < 4000);
    if (count == 0) return;
    with_lanes(count, [&]<unsigned lanes>() {
      sweep_rows<lanes><<<blocks(count * lanes), block_size>>>(count, sweep);
    });
    check_cuda(cudaGetLastError(), "kernel launch");
  }
  /// The same, with sum_up() of what finish(i, sums, sum) adds.
  template <class Sum, class Sweep, class Then>
  void sweep_and_sum(std::size_t count, const Sweep& sweep, const Then& then) const {
    with_lanes(count, [&]<unsigned lanes>() {
      // Whole warps.
      const std::size_t threads = (count * lanes + 31) / 32 * 32;
      start_sum<Sum>(threads, SumOverRows<lanes, Sweep>{count, sweep}, then);
    });
  }

  /// `count` values of zero bytes.
  template <class T>
  void zero(DeviceArray<T>& array, std::size_t count) const {
    array.resize(count);
    if (count > 0) check_cuda(cudaMemsetAsync(array.data(), 0, count * sizeof(T)), "cudaMemset");
  }
  /// Room for `count` values, which are whatever they are.
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
    if (from.empty()) return;
    move(from.data(), from.size(), to.data(), cudaMemcpyHostToDevice);
    wait("upload");  // `from` may be gone at once, and not every card has staged it by now
  }
  template <class T>
  void download(const DeviceArray<T>& from, std::vector<T>& to) const {
    to.resize(from.size());
    fetch(from.data(), from.size(), to.data());
  }
  /// The copy is there once await() has returned for a later moment.
  template <class T>
  void start_download(const DeviceArray<T>& from, PageLockedArray<T>& to) const {
    to.resize(from.size());
    move(from.data(), from.size(), to.data(), cudaMemcpyDeviceToHost);
  }
  template <class T>
  void copy(const DeviceArray<T>& from, DeviceArray<T>& to) const {
    to.resize(from.size());
    move(from.data(), from.size(), to.data(), cudaMemcpyDeviceToDevice);
  }
  /// The last value of an array.
  template <class T>
  T last(const DeviceArray<T>& array) const {
    T value;
    fetch(array.data() + array.size() - 1, 1, &value);
    return value;
  }

  /// Sorts pairs by the lowest `bits` of their keys; equal ones keep their order.
  void sort(DeviceArray<std::uint64_t>& keys, DeviceArray<std::uint32_t>& values, int bits) const;
  /// Each value becomes the sum of those before it.
  void scan(DeviceArray<std::uint64_t>& values) const;

  /// A place in the order of the work, for waits and for times between two of them, s.
  using Moment = CardMoment;
  Moment now() const { return CardMoment(); }
  /// Waits until the work has come there; from any thread.
  void await(const Moment& moment) const { moment.wait(); }
  double seconds_between(const Moment& start, const Moment& end) const {
    return end.seconds_since(start);
  }

 private:
  template <class Sum, class F, class Then>
  static void start_sum(std::size_t count, const F& f, const Then& then) {
    static_assert(std::is_trivially_copyable_v<F> && std::is_trivially_copyable_v<Then>);
    static_assert(sizeof(F) + sizeof(Then) < 4000);
    static_assert(std::is_trivially_copyable_v<Sum> && sizeof(Sum) <= SumSpace::largest);
    const SumSpace& space = sum_space();
    // One of nothing is handed on, too.
    const auto sums = std::clamp<std::size_t>(blocks(count), 1, most_partial_sums);
    sum_all<Sum><<<static_cast<unsigned>(sums), block_size>>>(
        count, f, then, static_cast<Sum*>(space.partial), space.blocks_done);
    check_cuda(cudaGetLastError(), "kernel launch");
  }
  /// Until all that was started is done.
  static void wait(const char* work) { check_cuda(cudaStreamSynchronize(nullptr), work); }
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
    if (count == 0) return;
    move(from, count, to, cudaMemcpyDeviceToHost);
    wait("pass");
  }
};

}  // namespace sabo
