#include "microbench/registered.hpp"
#include <benchmark/benchmark.h>

int main(int argc, char** argv) {
  sabo::register_pair_benchmarks();
  sabo::register_law_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
