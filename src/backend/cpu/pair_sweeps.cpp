#include "backend/cpu/pair_sweeps.hpp"

namespace sabo {

// src/backend/cpu/simd/pair_sweeps.cpp, compiled once for each instruction set.
extern const PairSweeps pair_sweeps_baseline;
#ifdef SABO_X86_SETS
extern const PairSweeps pair_sweeps_avx2;
extern const PairSweeps pair_sweeps_avx512;
#endif

const PairSweeps& best_pair_sweeps() {
#ifdef SABO_X86_SETS
  __builtin_cpu_init();
  const auto has_avx2 = [] {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("aes") &&
           __builtin_cpu_supports("pclmul");
  };
  const auto has_avx512 = [] {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512vl");
  };
  static const PairSweeps& best = !has_avx2()    ? pair_sweeps_baseline
                                  : has_avx512() ? pair_sweeps_avx512
                                                 : pair_sweeps_avx2;
  return best;
#else
  return pair_sweeps_baseline;
#endif
}

}  // namespace sabo
