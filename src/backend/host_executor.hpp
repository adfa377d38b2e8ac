#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/host_loops.hpp"

namespace sabo {

/// Where code that is written once for hosts and cards has its arrays and runs its loops: here in
/// the memory of the host, on its threads. Members are as those of the one for cards
/// (backend/cuda/cuda_executor.cuh), as far as backends of the host use them.
class HostExecutor {
 public:
  template <class T>
  using Array = std::vector<T>;

  explicit HostExecutor(int threads = 1) : threads_(threads) {}

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

  /// In an order that depends on `count` alone.
  template <class Sum, class F>
  Sum reduce(std::size_t count, const F& f) const {
    return blocked_sum<Sum>(count, threads_, f);
  }
  template <class Sum, class F, class Then>
  void sum_up(std::size_t count, const F& f, const Then& then) const {
    then(reduce<Sum>(count, f));
  }

  template <class T>
  void zero(Array<T>& array, std::size_t count) const {
    array.assign(count, T{});
  }
  template <class T>
  void reserve(Array<T>& array, std::size_t count) const {
    array.resize(count);
  }
  template <class T>
  T last(const Array<T>& array) const {
    return array.back();
  }

  void scan(Array<std::uint64_t>& values) const {
    std::exclusive_scan(values.begin(), values.end(), values.begin(), std::uint64_t{0});
  }

  int threads() const { return threads_; }

 private:
  int threads_;
};

}  // namespace sabo
