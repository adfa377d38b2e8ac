#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/bisect.hpp"
#include "base/host_device.hpp"
#include "particles/particles.hpp"

namespace sabo {

/// Consecutive particle numbers.
struct IdRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// A view of sorted runs that do not overlap; their array must outlive it.
struct IdRuns {
  const IdRun* runs;
  std::size_t count;

  SABO_HD bool hold(std::uint32_t id) const {
    const std::size_t beyond =
        bisect(std::size_t{0}, count, [&](std::size_t k) { return runs[k].first <= id; });
    return beyond > 0 && id - runs[beyond - 1].first < runs[beyond - 1].count;
  }
};

/// How the boundary particles follow the flow: some go, some come, all others keep all that they
/// have.
struct BoundaryChange {
  std::vector<IdRun> dropped;  ///< sorted and apart from each other
  Particles made;

  bool is_empty() const { return dropped.empty() && made.size() == 0; }
  /// Those that stay keep their order, new ones come last.
  void apply_to(Particles& boundary) const;
};

}  // namespace sabo
