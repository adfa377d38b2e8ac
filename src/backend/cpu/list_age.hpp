#pragma once

#include <cstdint>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// Tells whether the pairs of a neighbour list may have missed one since it was made. A pair that
/// is not listed was farther apart than the kernel by the skin: it takes a relative motion of the
/// skin to bring it in. Boundary particles are at rest, so no particle may move by more than the
/// skin; between fluid particles the motion that they share does not count, only how much it
/// differs between places near to each other.
class ListAge {
 public:
  /// Keeps the positions of the fluid at the time of the list. `reach` (m): radius of the list;
  /// with `periodic` all places count as near to each other.
  void start(const std::vector<Vec3d>& fluid, double reach, bool periodic);

  /// Whether the list holds for as long as no particle moves by more than `margin` (m) from where
  /// they are now. The skin must be at most half the reach.
  bool is_stale(const std::vector<Vec3d>& fluid, double skin, double margin) const;

  const std::vector<Vec3d>& start_positions() const { return start_; }

 private:
  std::vector<Vec3d> start_;
  std::vector<std::uint32_t> square_;  // of each particle, row by row
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace sabo
