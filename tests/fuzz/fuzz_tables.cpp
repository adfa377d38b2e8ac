#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.hpp"
#include "io/output/read_csv.hpp"
#include "io/output/read_hydrograph.hpp"

/// Whatever the bytes: a table of numbers is refused or whole, a hydrograph as well.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto table = sabo::parse_number_table(text)) {
    if (table->names.size() != table->columns.size()) __builtin_trap();
    for (const auto& column : table->columns)
      for (const double value : column)
        if (!std::isfinite(value)) __builtin_trap();
  }
  try {
    sabo::parse_hydrograph(text, "inflow.hydrograph", "a.csv");
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
