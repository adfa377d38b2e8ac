#include "backend/cpu/fma_probe.hpp"

#include "backend/cpu/pair_sweeps.hpp"

namespace sabo {

// src/backend/cpu/simd/fma_probe.cpp, compiled once for each instruction set.
extern const FmaProbe fma_probe_baseline;
#ifdef SABO_X86_SETS
extern const FmaProbe fma_probe_avx2;
extern const FmaProbe fma_probe_avx512;
#endif

std::vector<const FmaProbe*> all_fma_probes() {
#ifdef SABO_X86_SETS
  std::vector<const FmaProbe*> probes{&fma_probe_baseline, &fma_probe_avx2, &fma_probe_avx512};
#else
  std::vector<const FmaProbe*> probes{&fma_probe_baseline};
#endif
  probes.resize(all_pair_sweeps().size());  // those of the machine, which come first
  return probes;
}

}  // namespace sabo
