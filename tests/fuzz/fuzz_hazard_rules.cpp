#include <cstddef>
#include <cstdint>
#include <string_view>

#include "analysis/hazard_map.hpp"
#include "io/case_file/read_hazard_rules.hpp"

/// Whatever the bytes: the reader returns, and rules without faults can be used.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  sabo::Faults faults;
  const sabo::HazardRules rules = sabo::read_hazard_rules(text, "rules.toml", faults);
  if (!faults.empty()) return 0;
  const sabo::Raster ones({1, 1, 0, 1, 1, 1}, 1);
  sabo::HazardMaps maps;
  for (const sabo::HazardQuantity quantity : sabo::quantities_of(rules))
    maps.emplace(quantity, ones);
  const sabo::Raster classes = sabo::classify(rules, maps, 0);
  if (rules.matrix) sabo::levels_of(classes, rules, 50);
  return 0;
}
