#include "bench/pair_flops.hpp"

#include <utility>

namespace sabo {

double flops_of_pair(std::string_view pass) {
  constexpr std::pair<std::string_view, double> counted[] = {
      {"motion sweep", 73}, {"force sweep", 53}, {"wall pressure", 32}, {"force and matrix", 70},
      {"near motion", 73},  {"shifting", 23},    {"viscous solve", 63}};
  for (const auto& [name, flops] : counted)
    if (name == pass) return flops;
  return 0;
}

}  // namespace sabo
