#include "bench/peak.hpp"

#include <chrono>

#include <fmt/format.h>

namespace sabo {
namespace {

/// Seconds that all threads together need for that many rounds each.
double time_of(const FmaProbe& probe, std::size_t rounds, int threads) {
  using Clock = std::chrono::steady_clock;
  volatile float sink = 0;
  const auto start = Clock::now();
#pragma omp parallel num_threads(threads)
  {
    const float result = probe.run(rounds);
#pragma omp critical
    sink = sink + result;
  }
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

std::string common_name(const char* instruction_set) {
  const std::string name = instruction_set;
  return name == "AVX3" ? "AVX-512" : name;
}

Samples peak_of(const FmaProbe& probe, int threads, const BenchSettings& settings) {
  const double wanted = settings.quick ? 0.004 : 0.04;
  std::size_t rounds = 1000;
  while (time_of(probe, rounds, threads) < wanted) rounds *= 2;
  Samples samples;
  for (int repeat = 0; repeat < settings.repeats(); ++repeat) {
    const double flops = static_cast<double>(rounds) * probe.flops_per_round * threads;
    samples.values.push_back(flops / time_of(probe, rounds, threads));
  }
  return samples;
}

BenchResult bench_peak(const BenchSettings& settings) {
  BenchResult result;
  BenchTable table;
  table.title = "Peak of multiply-add in single precision, in registers";
  table.header = {"instruction set", "one core, GFlop/s",
                  fmt::format("{}, GFlop/s", threads_text(settings.threads))};
  for (const FmaProbe* probe : all_fma_probes()) {
    std::vector<std::string> row{common_name(probe->instruction_set)};
    for (const auto& [threads, what] : {std::pair{1, "one core"}, {settings.threads, "all"}}) {
      const Samples speed = peak_of(*probe, threads, settings);
      const Samples giga = speed.mapped([](double flops) { return 1e-9 * flops; });
      result.measurements.emplace_back(fmt::format("peak/{}/{}", row.front(), what), "GFlop/s",
                                       giga);
      row.push_back(fmt::format("{:.1f}", giga.median()));
    }
    table.rows.push_back(std::move(row));
  }
  table.notes = {"A multiply-add counts as two; SSSE3 has none and multiplies and adds in turn."};
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace sabo
