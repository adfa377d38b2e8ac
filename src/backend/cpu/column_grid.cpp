#include "backend/cpu/column_grid.hpp"

#include <numeric>

namespace sabo {

ColumnGrid::ColumnGrid(const Vec3d& low, const Vec3d& high, double width)
    : low_(low),
      width_(width),
      nx_(1 + static_cast<int>((high.x - low.x) / width)),
      ny_(1 + static_cast<int>((high.y - low.y) / width)) {}

int ColumnGrid::column_x(double x) const {
  return std::clamp(static_cast<int>(std::floor((x - low_.x) / width_)), 0, nx_ - 1);
}
int ColumnGrid::column_y(double y) const {
  return std::clamp(static_cast<int>(std::floor((y - low_.y) / width_)), 0, ny_ - 1);
}

std::vector<std::uint32_t> ColumnGrid::sorted_order(const std::vector<Vec3d>& position,
                                                    const std::vector<std::uint32_t>& id,
                                                    int threads) {
  const std::size_t columns = static_cast<std::size_t>(nx_) * ny_;
  std::vector<std::uint32_t> column_of(position.size());
  first_.assign(columns + 1, 0);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const std::size_t column =
        static_cast<std::size_t>(column_y(position[i].y)) * nx_ + column_x(position[i].x);
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

}  // namespace sabo
