#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "terrain/polyline.hpp"

namespace sabo {

/// A path that has crossed a curtain.
struct Crossing {
  std::uint32_t row;
  int net;  ///< not 0
};

/// Vertical curtain over a polyline, open at its ends; counts the straight paths that cross it.
class Curtain {
 public:
  explicit Curtain(Polyline line);

  /// Net number of crossings of the straight path from -> to, seen in plan: +1 for each from the
  /// left to the right side, looking from the first to the last vertex, -1 for each the other way.
  ///
  /// Each path counts as if it were shifted by a vanishing amount (e, e^2), the same for every
  /// path: then no point lies on the line and no path meets a vertex. So a path through a vertex
  /// crosses once, and a path in several steps crosses as often as the steps together, also when a
  /// step ends on the line.
  int crossings(const Vec3d& from, const Vec3d& to) const {
    // Most paths are far away, and this test is all they cost.
    const bool is_apart = (from.x < west_ && to.x < west_) || (from.x > east_ && to.x > east_) ||
                          (from.y < south_ && to.y < south_) || (from.y > north_ && to.y > north_);
    return is_apart ? 0 : count(from, to);
  }

  /// Those of many paths from -> to that cross it, in their order. Threads: 0 stands for all.
  std::vector<Crossing> crossings(std::span<const Vec3d> from, std::span<const Vec3d> to,
                                  int threads) const;

 private:
  int count(const Vec3d& from, const Vec3d& to) const;

  Polyline line_;
  double west_, east_, south_, north_;
};

}  // namespace sabo
