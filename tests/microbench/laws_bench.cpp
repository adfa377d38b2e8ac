// Formulas of single particles; items are particles.

#include <string>
#include <variant>
#include <vector>

#include "microbench/registered.hpp"
#include <benchmark/benchmark.h>

#include "physics/equation_of_state.hpp"
#include "physics/rheology_list.hpp"

namespace sabo {
namespace {

constexpr std::size_t particles = 1024;

/// Shear rates from creep to fast flow, at a yield stress and a pressure.
std::vector<Shear> shears() {
  std::vector<Shear> result;
  for (std::size_t k = 0; k < particles; ++k)
    result.push_back({0.01 * static_cast<double>(k), 200, 5000});
  return result;
}

void pressure(benchmark::State& state) {
  const Tait water{1000, 20};
  std::vector<double> density(particles), result(particles);
  for (std::size_t k = 0; k < particles; ++k) density[k] = 1000 + 0.01 * static_cast<double>(k);
  for ([[maybe_unused]] auto unused : state) {
    for (std::size_t k = 0; k < particles; ++k) result[k] = water.pressure(density[k]);
    benchmark::DoNotOptimize(result.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles));
}
BENCHMARK(pressure);

void viscosity(benchmark::State& state, const Rheology& rheology) {
  const std::vector<Shear> at = shears();
  std::vector<double> result(particles);
  std::visit(
      [&](const auto& law) {
        for ([[maybe_unused]] auto unused : state) {
          for (std::size_t k = 0; k < particles; ++k) result[k] = law.viscosity(at[k]);
          benchmark::DoNotOptimize(result.data());
          benchmark::ClobberMemory();
        }
      },
      rheology);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles));
}

}  // namespace

void register_law_benchmarks() {
  for (const Rheology& law : all_rheologies())
    benchmark::RegisterBenchmark(("viscosity/" + std::string(name_of(law))).c_str(),
                                 [law](benchmark::State& state) { viscosity(state, law); });
}

}  // namespace sabo
