#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

#include <omp.h>

namespace sabo {

/// Threads of loops on the host; 0 stands for all.
inline int host_threads(int wanted) { return wanted > 0 ? wanted : omp_get_max_threads(); }

/// Loops that do little for each of fewer particles than this are over before other threads have
/// woken up.
inline constexpr std::ptrdiff_t worth_threads = 4096;

/// f(i) for i in [0, count) on all threads; f writes to i alone.
template <class F>
void over(std::size_t count, int threads, const F& f) {
  const auto last = static_cast<std::ptrdiff_t>(count);
#pragma omp parallel for num_threads(threads) if (last > worth_threads) schedule(static)
  for (std::ptrdiff_t i = 0; i < last; ++i) f(static_cast<std::size_t>(i));
}

/// Takes what is thrown within a parallel region, which no exception may leave, to its end.
class ThrownInside {
 public:
  template <class F>
  void watch(const F& f) {
    try {
      f();
    } catch (...) {
#pragma omp critical(sabo_thrown_inside)
      thrown_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::exception_ptr thrown_;
};

/// over() for few things, each of which takes long and may throw; one of the exceptions comes out.
template <class F>
void over_few(std::size_t count, int threads, const F& f) {
  ThrownInside thrown;
#pragma omp parallel for num_threads(threads) if (count > 1) schedule(dynamic, 1)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i)
    thrown.watch([&] { f(static_cast<std::size_t>(i)); });
  thrown.rethrow();
}

/// f(i) for the particles named in `rows`.
template <class F>
void over_rows(const std::vector<std::uint32_t>& rows, int threads, const F& f) {
  over(rows.size(), threads, [&](std::size_t k) { f(std::size_t{rows[k]}); });
}

/// Joins what f(k, sum) adds to sums of fixed blocks, in their order, so that the result has the
/// same bits for any number of threads. A Sum starts as Sum{} and has join(other); f may throw.
template <class Sum, class F>
Sum blocked_sum(std::size_t count, int threads, const F& f) {
  constexpr std::size_t block = 1024;
  const std::size_t blocks = (count + block - 1) / block;
  std::vector<Sum> partial(blocks);
  ThrownInside thrown;
#pragma omp parallel for num_threads(threads) if (blocks > 3) schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    const std::size_t last = std::min(count, (b + 1) * block);
    thrown.watch([&] {
      Sum sum;
      for (std::size_t k = b * block; k < last; ++k) f(k, sum);
      partial[b] = std::move(sum);
    });
  }
  thrown.rethrow();
  Sum total;
  for (const Sum& sum : partial) total.join(sum);
  return total;
}

}  // namespace sabo
