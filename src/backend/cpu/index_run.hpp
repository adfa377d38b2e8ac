#pragma once

#include <cstdint>

namespace sabo {

/// Half-open range of particle indices.
struct IndexRun {
  std::uint32_t first = 0, last = 0;
};

}  // namespace sabo
