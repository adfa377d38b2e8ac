#include "backend/cpu/pair_sweeps.hpp"

namespace sabo {

// src/backend/cpu/simd/pair_sweeps.cpp, compiled once for each instruction set.
extern const PairSweeps pair_sweeps_baseline;
#ifdef SABO_X86_SETS
extern const PairSweeps pair_sweeps_avx2;
extern const PairSweeps pair_sweeps_avx512;
#endif

namespace {

std::vector<const PairSweeps*> supported_pair_sweeps() {
  std::vector<const PairSweeps*> sets{&pair_sweeps_baseline};
#ifdef SABO_X86_SETS
  __builtin_cpu_init();
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                        __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("aes") &&
                        __builtin_cpu_supports("pclmul");
  const bool has_avx512 = has_avx2 && __builtin_cpu_supports("avx512f") &&
                          __builtin_cpu_supports("avx512bw") &&
                          __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512vl");
  if (has_avx2) sets.push_back(&pair_sweeps_avx2);
  if (has_avx512) sets.push_back(&pair_sweeps_avx512);
#endif
  return sets;
}

}  // namespace

const std::vector<const PairSweeps*>& all_pair_sweeps() {
  static const std::vector<const PairSweeps*> sets = supported_pair_sweeps();
  return sets;
}

}  // namespace sabo
