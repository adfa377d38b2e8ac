#pragma once

namespace sabo {

// Benchmarks whose names are known only once the program runs. Called from main(), when all tables
// of the backends are ready.
void register_pair_benchmarks();
void register_law_benchmarks();

}  // namespace sabo
