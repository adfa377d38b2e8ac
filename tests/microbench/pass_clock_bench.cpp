// What a clock costs that a pass has at its head.

#include <benchmark/benchmark.h>

#include "backend/pass_times.hpp"

namespace sabo {
namespace {

void pass_clock(benchmark::State& state) {
  PassTimes times;
  for (const char* name : {"sort", "neighbour search", "pressure", "records", "motion sweep",
                           "stress", "force sweep", "checks and sums", "integration"})
    times[name].calls = 0;
  for ([[maybe_unused]] auto unused : state) const PassClock clock(times, "integration");
  benchmark::DoNotOptimize(times.seconds());
}
BENCHMARK(pass_clock);

}  // namespace
}  // namespace sabo
