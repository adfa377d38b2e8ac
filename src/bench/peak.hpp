#pragma once

#include <string>

#include "backend/cpu/fma_probe.hpp"
#include "bench/parts.hpp"

namespace sabo {

/// Flop/s of a probe on that many threads together; a multiply-add counts as two.
Samples peak_of(const FmaProbe& probe, int threads, const BenchSettings& settings);

/// What people call an instruction set: "AVX-512" for Highway's "AVX3".
std::string common_name(const char* instruction_set);

}  // namespace sabo
