#include "backend/cpu/column_grid.hpp"

#include <algorithm>
#include <numeric>

namespace sabo {
namespace {

// Places as near to each other in height as this, in radii, share their runs: a few candidates more
// cost less than branches that no processor can predict.
constexpr double shared_height = 0.25;

}  // namespace

ColumnGrid::ColumnGrid(const Vec3d& low, const Vec3d& high, double width) : width_(width) {
  west_ = lattice(low.x);
  south_ = lattice(low.y);
  nx_ = static_cast<int>(lattice(high.x) - west_) + 1;
  ny_ = static_cast<int>(lattice(high.y) - south_) + 1;
}

std::vector<std::uint32_t> ColumnGrid::sorted_order(const std::vector<Vec3d>& position,
                                                    const std::vector<std::uint32_t>& id,
                                                    int threads) {
  const std::size_t columns = static_cast<std::size_t>(nx_) * ny_;
  std::vector<std::uint32_t> column_of(position.size());
  first_.assign(columns + 1, 0);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const std::size_t column = static_cast<std::size_t>(lattice(position[i].y) - south_) * nx_ +
                               static_cast<std::size_t>(lattice(position[i].x) - west_);
    column_of[i] = static_cast<std::uint32_t>(column);
    ++first_[column + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());

  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  std::vector<std::uint32_t> order(position.size());
  for (std::size_t i = 0; i < position.size(); ++i)
    order[next[column_of[i]]++] = static_cast<std::uint32_t>(i);

  const auto lower = [&](std::uint32_t a, std::uint32_t b) {
    return position[a].z != position[b].z ? position[a].z < position[b].z : id[a] < id[b];
  };
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::ptrdiff_t column = 0; column < static_cast<std::ptrdiff_t>(columns); ++column)
    std::sort(order.begin() + first_[column], order.begin() + first_[column + 1], lower);
  return order;
}

void ColumnGrid::Runs::move_to(const Vec3d& x) {
  const std::int64_t column_x = grid_.lattice(x.x);
  const std::int64_t column_y = grid_.lattice(x.y);
  const bool is_near = is_inside_ && column_x == column_x_ && column_y == column_y_ && x.z >= low_;
  if (is_near && x.z <= high_) return;
  if (!is_near) enter(column_x, column_y, x.z);
  low_ = x.z;
  high_ = x.z + shared_height * radius_;
  for (int k = 0; k < count_; ++k) {
    IndexRun& run = runs_[k];
    while (run.first != end_[k] && position_[run.first].z < low_ - radius_) ++run.first;
    run.last = std::max(run.last, run.first);
    while (run.last != end_[k] && position_[run.last].z < high_ + radius_) ++run.last;
  }
}

/// Starts below z in the columns around one.
void ColumnGrid::Runs::enter(std::int64_t column_x, std::int64_t column_y, double z) {
  column_x_ = column_x;
  column_y_ = column_y;
  is_inside_ = true;
  count_ = 0;
  const auto below = [](const Vec3d& p, double height) { return p.z < height; };
  for (std::int64_t iy = column_y - 1 - grid_.south_; iy <= column_y + 1 - grid_.south_; ++iy) {
    for (std::int64_t ix = column_x - 1 - grid_.west_; ix <= column_x + 1 - grid_.west_; ++ix) {
      if (ix < 0 || iy < 0 || ix >= grid_.nx_ || iy >= grid_.ny_) continue;
      const std::size_t column = static_cast<std::size_t>(iy) * grid_.nx_ + ix;
      const auto begin = position_.begin() + grid_.first_[column];
      const auto end = position_.begin() + grid_.first_[column + 1];
      const auto first = std::lower_bound(begin, end, z - radius_, below);
      const auto at = [&](auto place) {
        return static_cast<std::uint32_t>(place - position_.begin());
      };
      if (first == end) continue;
      runs_[count_] = {at(first), at(first)};
      end_[count_++] = at(end);
    }
  }
}

std::size_t ColumnGrid::Runs::size() const {
  std::size_t sum = 0;
  for (int k = 0; k < count_; ++k) sum += runs_[k].last - runs_[k].first;
  return sum;
}

}  // namespace sabo
