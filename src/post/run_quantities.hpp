#pragma once

#include <string>
#include <utility>
#include <vector>

#include "post/finished_run.hpp"

namespace sabo {

/// Numbers that sum up a run, as its manifest has them, each with a label that ends in its unit:
/// released volume, key quantities, depth in zones, loads on structures.
std::vector<std::pair<std::string, double>> quantities_of(const FinishedRun& run);

/// A quantity in two runs; NaN where one has it not.
struct QuantityPair {
  std::string label;
  double a = 0;
  double b = 0;
};

/// The quantities of both, in the order of a, then what only b has.
std::vector<QuantityPair> paired_quantities(const FinishedRun& a, const FinishedRun& b);

}  // namespace sabo
