#pragma once

#include <vector>

#include "particles/places.hpp"

namespace sabo {

/// Where each particle was at the last call, found by its number: the solver may sort its rows in
/// between, and particles may have left or come.
class Tracks {
 public:
  /// Positions at the last call in the row order of `particles`, and keeps the present ones. A
  /// particle seen for the first time has its present position. Valid until the next call.
  /// Threads: 0 stands for all.
  const std::vector<Vec3d>& advance(const Places& particles, int threads = 1);

  template <class Archive>
  void archive(Archive& a) {
    a(last_);
  }

 private:
  std::vector<Vec3d> last_;    // by particle number; NaN where unknown
  std::vector<Vec3d> before_;  // by row
};

}  // namespace sabo
