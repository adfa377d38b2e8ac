#include "io/case_file/check_inflows.hpp"

#include <string>

#include <fmt/format.h>

#include "io/case_file/check_parts.hpp"

namespace sabo {
namespace {

void check_surge(const Surge& surge, const std::string& path, Faults& faults) {
  for (const char* key : {".start", ".peak_time", ".end"})
    if (faults.has(path + key)) return;
  if (!(surge.start < surge.end)) {
    faults.add(path + ".end", fmt::format("is not after its start at {:g} s", surge.start),
               "give a later time");
  } else if (surge.peak_time < surge.start || surge.peak_time > surge.end) {
    faults.add(path + ".peak_time",
               fmt::format("is not between {:g} and {:g} s, when the surge passes", surge.start,
                           surge.end),
               "give a time between its start and its end");
  }
}

}  // namespace

void check_inflows(const std::vector<InflowCase>& inflows, Faults& faults) {
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    const InflowCase& inflow = inflows[i];
    const std::string path = fmt::format("inflow[{}]", i + 1);
    check_line(inflow.line, path + ".line", faults);
    const bool has_file = !inflow.hydrograph.empty() || faults.has(path + ".hydrograph");
    const bool has_surges = !inflow.surges.empty() || faults.has(path + ".surge");
    if (has_file == has_surges)
      faults.add(path, has_file ? "has a hydrograph and surges" : "has no discharge",
                 "give one of hydrograph, a CSV file, and [[inflow.surge]]");
    for (std::size_t k = 0; k < inflow.surges.size(); ++k)
      check_surge(inflow.surges[k], fmt::format("{}.surge[{}]", path, k + 1), faults);
    if (inflow.speed && inflow.froude != InflowCase{}.froude && !faults.has(path + ".froude"))
      faults.add(path + ".froude", "the speed is given too", "give one of speed and froude");
  }
  check_names(inflows, "inflow", faults);
}

}  // namespace sabo
