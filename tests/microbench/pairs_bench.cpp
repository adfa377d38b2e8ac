// Parts of the pair sweeps for every instruction set of the machine, on data that fit the first
// cache: what is left of the time of a sweep goes into the way to the neighbours.

#include <algorithm>
#include <numeric>
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

/// Rows of the viscous matrix with as many fluid neighbours as inside a flow (h/dp = 1.5).
constexpr std::size_t rows = 16, neighbours = 112;

NearPairs matrix() {
  NearPairs near;
  near.reset(rows);
  NearPairs::Writer writer(near, 0, rows * (neighbours + PairList::lanes));
  for (std::uint32_t i = 0; i < rows; ++i) {
    writer.begin_row(i);
    for (std::uint32_t k = 0; k < neighbours; ++k) {
      writer.index()[k] = (i + 1 + k) % pairs;
      writer.conductance()[k] = 0.01f * static_cast<float>(k);
    }
    writer.advance(neighbours);
    writer.end_fluid();
    writer.end_row();
  }
  return near;
}

/// The product of the viscous solve; items are pairs.
void register_product(const std::string& set, const PairSweeps& sweeps) {
  benchmark::RegisterBenchmark(("viscous_product/" + set).c_str(), [&](benchmark::State& state) {
    const NearPairs near = matrix();
    std::vector<std::uint32_t> row(rows);
    std::iota(row.begin(), row.end(), 0U);
    const PairScale scale;
    const std::vector<ViscousRecord> records(pairs);
    std::vector<Quad<float>> q(rows);
    const std::vector<float> mass(rows, 1), drag(rows, 0.5f);
    const std::vector<Sym3<float>> inverse_root(rows, isotropic(1.0f));
    std::vector<VelocityGradient<float>> half_gradient(rows);
    ViscousProductTask task{&scale,      &near,       row.data(), 0,        rows, records.data(),
                            mass.data(), drag.data(), 0.1f,       q.data(), 0};
    for ([[maybe_unused]] auto unused : state) {
      sweeps.half_gradient({&scale, &near, row.data(), 0, rows, records.data(), inverse_root.data(),
                            half_gradient.data()});
      sweeps.viscous_product(task);
      benchmark::DoNotOptimize(task.dot);
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(near.size()));
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
  for (std::size_t k = 0; k < all_pair_sweeps().size(); ++k) {
    const PairSweeps& sweeps = *all_pair_sweeps()[k];
    register_set(sweeps.instruction_set, *parts[k]);
    register_product(sweeps.instruction_set, sweeps);
  }
}

}  // namespace sabo
