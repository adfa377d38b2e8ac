#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "base/host_loops.hpp"

namespace sabo {

/// Where code that is written once for hosts and devices has its arrays and runs its loops: here in
/// the memory of the host, on its threads. backend/cuda/cuda_executor.cuh is the other one.
///
/// Loop bodies are structs of plain values and pointers whose operator() is SABO_HD.
class HostExecutor {
 public:
  template <class T>
  using Array = std::vector<T>;
  /// On the host, where copies to it are made beside other work.
  template <class T>
  using StagingArray = std::vector<T>;

  /// `row_shares`: in how many parts a row of pairs is summed up, as by as many threads of a card.
  explicit HostExecutor(int threads = 1, std::uint32_t row_shares = 1)
      : threads_(threads), row_shares_(row_shares) {}

  /// f(i) for i in [0, count); f writes to i alone.
  template <class F>
  void for_each(std::size_t count, const F& f) const {
    over(count, threads_, f);
  }

  /// The same where each i takes long, or takes longer than others.
  template <class F>
  void for_each_slow(std::size_t count, const F& f) const {
#pragma omp parallel for num_threads(threads_) schedule(static)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i)
      f(static_cast<std::size_t>(i));
  }

  /// Joins what f(k, sum) adds, in an order that depends on `count` alone.
  template <class Sum, class F>
  Sum reduce(std::size_t count, const F& f) const {
    return blocked_sum<Sum>(count, threads_, f);
  }

  /// The same; the sum becomes the one value of `total`, where it can be read without a wait.
  template <class Sum, class F>
  void sum_into(std::size_t count, const F& f, Array<Sum>& total) const {
    total.assign(1, reduce<Sum>(count, f));
  }

  /// A sweep over the pairs of each i in [0, count); see backend/device/pair_rows.hpp.
  template <class Sweep>
  void sweep(std::size_t count, const Sweep& sweep) const {
    for_each(count, [&](std::size_t i) { sweep.finish(i, sums_of_row(sweep, i)); });
  }
  /// The same, with sum_into() of what finish(i, sums, sum) adds.
  template <class Sum, class Sweep>
  void sweep_and_sum(std::size_t count, const Sweep& sweep, Array<Sum>& total) const {
    total.assign(1, reduce<Sum>(count, [&](std::size_t i, Sum& sum) {
                   sweep.finish(i, sums_of_row(sweep, i), sum);
                 }));
  }

  template <class T>
  void zero(Array<T>& array, std::size_t count) const {
    array.assign(count, T{});
  }
  /// Room for `count` values, which are whatever they are: here such that no sum survives them.
  template <class T>
  void reserve(Array<T>& array, std::size_t count) const {
    array.resize(count);
    if (count > 0) std::memset(static_cast<void*>(array.data()), 0xff, count * sizeof(T));
  }
  template <class T>
  void release(Array<T>& array) const {
    Array<T>().swap(array);
  }

  template <class T>
  void upload(const std::vector<T>& from, Array<T>& to) const {
    to = from;
  }
  template <class T>
  void download(const Array<T>& from, std::vector<T>& to) const {
    to = from;
  }
  /// The copy is there once await() has returned for a later moment.
  template <class T>
  void start_download(const Array<T>& from, StagingArray<T>& to) const {
    to = from;
  }
  template <class T>
  void copy(const Array<T>& from, Array<T>& to) const {
    to = from;
  }
  /// The last value of an array.
  template <class T>
  T last(const Array<T>& array) const {
    return array.back();
  }

  /// Sorts pairs by the lowest `bits` of their keys; equal ones keep their order.
  void sort(Array<std::uint64_t>& keys, Array<std::uint32_t>& values, int /*bits*/) const {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> pairs(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) pairs[i] = {keys[i], values[i]};
    std::ranges::stable_sort(pairs, {}, &std::pair<std::uint64_t, std::uint32_t>::first);
    for (std::size_t i = 0; i < keys.size(); ++i) std::tie(keys[i], values[i]) = pairs[i];
  }

  /// Each value becomes the sum of those before it.
  void scan(Array<std::uint64_t>& values) const {
    std::exclusive_scan(values.begin(), values.end(), values.begin(), std::uint64_t{0});
  }

  /// A place in the order of the work, for times between two of them, s.
  using Moment = std::chrono::steady_clock::time_point;
  Moment now() const { return std::chrono::steady_clock::now(); }
  /// Waits until the work has come there; from any thread.
  void await(const Moment& /*moment*/) const {}
  double seconds_between(const Moment& start, const Moment& end) const {
    return std::chrono::duration<double>(end - start).count();
  }

  int threads() const { return threads_; }

 private:
  template <class Sweep>
  auto sums_of_row(const Sweep& sweep, std::size_t i) const {
    auto sums = sweep.sums_of(i, {0, row_shares_});
    for (std::uint32_t k = 1; k < row_shares_; ++k) sums.join(sweep.sums_of(i, {k, row_shares_}));
    return sums;
  }

  int threads_;
  std::uint32_t row_shares_;
};

}  // namespace sabo
