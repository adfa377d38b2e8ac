#pragma once

#include <algorithm>
#include <cmath>

#include "backend/cpu/column_grid.hpp"

namespace sabo {

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
