#include "backend/cpu/list_age.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "backend/cpu/neighbour_search.hpp"

namespace sabo {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Smallest box that holds a set of displacements.
struct Box {
  Vec3d low{infinity, infinity, infinity};
  Vec3d high{-infinity, -infinity, -infinity};

  void hold(const Vec3d& a, const Vec3d& b) {
    low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
    high = {std::max(high.x, b.x), std::max(high.y, b.y), std::max(high.z, b.z)};
  }
  double diagonal() const { return low.x <= high.x ? norm(high - low) : 0; }
};

}  // namespace

void ListAge::start(const std::vector<Vec3d>& fluid, double reach, bool periodic) {
  start_ = fluid;
  square_.assign(fluid.size(), 0);
  columns_ = rows_ = 1;
  if (periodic || fluid.empty()) return;
  // Pairs that were farther apart than twice the reach cannot meet while nothing moves by more than
  // the skin: squares of that side and their neighbours hold all that can.
  const double side = 2 * reach;
  Vec3d low, high;
  bounding_box({&fluid}, low, high);
  columns_ = 1 + static_cast<int>((high.x - low.x) / side);
  rows_ = 1 + static_cast<int>((high.y - low.y) / side);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const int column = std::min(columns_ - 1, static_cast<int>((fluid[i].x - low.x) / side));
    const int row = std::min(rows_ - 1, static_cast<int>((fluid[i].y - low.y) / side));
    square_[i] = static_cast<std::uint32_t>(row) * columns_ + column;
  }
}

bool ListAge::is_stale(const std::vector<Vec3d>& fluid, double skin, double margin) const {
  if (fluid.size() != start_.size()) return true;
  std::vector<Box> boxes(static_cast<std::size_t>(columns_) * rows_);
  double moved2 = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d d = fluid[i] - start_[i];
    moved2 = std::max(moved2, dot(d, d));
    boxes[square_[i]].hold(d, d);
  }
  if (!(std::sqrt(moved2) + margin <= skin)) return true;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      Box box;
      for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
          const Box& other = boxes[static_cast<std::size_t>(r) * columns_ + c];
          box.hold(other.low, other.high);
        }
      }
      if (box.diagonal() + 2 * margin > skin) return true;
    }
  }
  return false;
}

}  // namespace sabo
