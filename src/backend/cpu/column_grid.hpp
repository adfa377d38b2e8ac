#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// Square columns in plan over a cloud of particles; within a column particles stand in order of
/// height. A valley is wide and shallow: columns cost memory by its plan area only, and a range of
/// heights within a column is found by bisection.
class ColumnGrid {
 public:
  /// Lays columns of the given width over the box [low, high] in plan.
  ColumnGrid(const Vec3d& low, const Vec3d& high, double width);
  ColumnGrid() = default;

  /// Order that sorts the positions by column, height and id: the same for any number of threads.
  std::vector<std::uint32_t> sorted_order(const std::vector<Vec3d>& position,
                                          const std::vector<std::uint32_t>& id, int threads);

  /// Calls f(first, last) for the particles of each column within `radius` of x in plan, cut to
  /// heights within `radius`. Positions must be those of the last sorted_order(), in that order.
  template <class F>
  void for_each_run(const std::vector<Vec3d>& position, const Vec3d& x, double radius,
                    const F& f) const;

 private:
  int column_x(double x) const;
  int column_y(double y) const;

  Vec3d low_;
  double width_ = 1;
  int nx_ = 0;
  int ny_ = 0;
  std::vector<std::uint32_t> first_;  // nx ny + 1
};

template <class F>
void ColumnGrid::for_each_run(const std::vector<Vec3d>& position, const Vec3d& x, double radius,
                              const F& f) const {
  if (nx_ == 0) return;
  const int x0 = std::max(0, static_cast<int>(std::floor((x.x - radius - low_.x) / width_)));
  const int x1 = std::min(nx_ - 1, static_cast<int>(std::floor((x.x + radius - low_.x) / width_)));
  const int y0 = std::max(0, static_cast<int>(std::floor((x.y - radius - low_.y) / width_)));
  const int y1 = std::min(ny_ - 1, static_cast<int>(std::floor((x.y + radius - low_.y) / width_)));
  const auto below = [](const Vec3d& p, double z) { return p.z < z; };
  for (int iy = y0; iy <= y1; ++iy) {
    for (int ix = x0; ix <= x1; ++ix) {
      const std::size_t column = static_cast<std::size_t>(iy) * nx_ + ix;
      const auto begin = position.begin() + first_[column];
      const auto end = position.begin() + first_[column + 1];
      auto run = std::lower_bound(begin, end, x.z - radius, below);
      const auto stop = std::lower_bound(run, end, x.z + radius, below);
      if (run != stop)
        f(static_cast<std::uint32_t>(run - position.begin()),
          static_cast<std::uint32_t>(stop - position.begin()));
    }
  }
}

}  // namespace sabo
