// Parts of the pair sweeps for every instruction set of the machine, on data that fit the first
// cache: what is left of the time of a sweep goes into the way to the neighbours.

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "microbench/registered.hpp"
#include "microbench/simd_parts.hpp"
#include <benchmark/benchmark.h>

#include "backend/cpu/pair_sweeps.hpp"

namespace sabo {

extern const SimdParts simd_parts_baseline;
#ifdef SABO_X86_SETS
extern const SimdParts simd_parts_avx2;
extern const SimdParts simd_parts_avx512;
#endif

namespace {

constexpr std::size_t pairs = 256;

std::vector<float> random_numbers(std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> u(0.1f, 1.0f);
  std::vector<float> numbers(count);
  for (float& number : numbers) number = u(random);
  return numbers;
}

/// Every row of records once, in no order.
std::vector<std::uint32_t> random_order() {
  std::vector<std::uint32_t> order(pairs);
  for (std::uint32_t k = 0; k < pairs; ++k) order[k] = k;
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  return order;
}

template <class Run>
void register_pairs(const std::string& name, const Run& run) {
  benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& state) {
    for ([[maybe_unused]] auto unused : state) benchmark::DoNotOptimize(run());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
  });
}

void register_set(const std::string& set, const SimdParts& parts) {
  // A record is aligned as in the backend: to its size.
  struct alignas(64) Line {
    float numbers[16];
  };
  static std::vector<Line> lines(pairs);
  static const std::vector<float> columns = random_numbers(16 * pairs);
  static const std::vector<std::uint32_t> order = random_order();
  for (std::size_t k = 0; k < columns.size(); ++k) lines[k / 16].numbers[k % 16] = columns[k];
  const float* records = lines[0].numbers;
  register_pairs("transpose_half/" + set,
                 [=] { return parts.transpose_half(records, order.data(), pairs); });
  register_pairs("transpose_line/" + set,
                 [=] { return parts.transpose_line(records, order.data(), pairs); });
  register_pairs("kernel/" + set, [=] { return parts.kernel(columns.data(), pairs); });
  register_pairs("motion_formulas/" + set, [=] { return parts.motion(columns.data(), pairs); });
  register_pairs("force_formulas/" + set, [=] { return parts.force(columns.data(), pairs); });
}

}  // namespace

void register_pair_benchmarks() {
  std::vector<const SimdParts*> parts{&simd_parts_baseline};
#ifdef SABO_X86_SETS
  parts.insert(parts.end(), {&simd_parts_avx2, &simd_parts_avx512});
#endif
  for (std::size_t k = 0; k < all_pair_sweeps().size(); ++k)
    register_set(all_pair_sweeps()[k]->instruction_set, *parts[k]);
}

}  // namespace sabo
