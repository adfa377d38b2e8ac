#pragma once

#include <cstddef>
#include <vector>

namespace sabo {

/// A loop that does nothing but multiply and add in registers: the most that a core can compute
/// with an instruction set, what the pair sweeps are measured against.
struct FmaProbe {
  const char* instruction_set;
  std::size_t flops_per_round;
  /// Does that many rounds; the result has no meaning but must be used.
  float (*run)(std::size_t rounds);
};

/// The probe for every instruction set this machine has, in the order of all_pair_sweeps().
std::vector<const FmaProbe*> all_fma_probes();

}  // namespace sabo
