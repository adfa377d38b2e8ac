#pragma once

#include <algorithm>
#include <cstddef>

namespace sabo {

/// Half-open range of indices.
struct Range {
  std::size_t first, last;
};

/// Particles that a thread takes at a time in a sweep over pairs.
inline constexpr std::size_t sweep_block = 128;

/// Runs f(range) over fixed blocks of [0, count) on all threads.
template <class F>
void parallel_blocks(std::size_t count, std::size_t block, int threads, const F& f) {
  const auto blocks = static_cast<std::ptrdiff_t>((count + block - 1) / block);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (std::ptrdiff_t b = 0; b < blocks; ++b) f(Range{b * block, std::min(count, (b + 1) * block)});
}

}  // namespace sabo
