#include "geometry/inside_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sabo {
namespace {

constexpr double most_cells = 4e6;

}  // namespace

InsideMap::InsideMap(std::shared_ptr<const MeshDistance> mesh, double cell)
    : mesh_(std::move(mesh)), cell_(cell) {
  const Vec3d size = mesh_->bounds().size();
  const auto cells = [](double length, double c) { return std::floor(length / c) + 1; };
  while (cells(size.x, cell_) * cells(size.y, cell_) * cells(size.z, cell_) > most_cells)
    cell_ *= 1.25;
  count_[0] = static_cast<int>(cells(size.x, cell_));
  count_[1] = static_cast<int>(cells(size.y, cell_));
  count_[2] = static_cast<int>(cells(size.z, cell_));
  sides_.resize(index(0, 0, count_[2]), Side::both);
  fill({{0, 0, 0}, {count_[0], count_[1], count_[2]}});
}

bool InsideMap::is_inside(const Vec3d& point) const {
  const Bounds& bounds = mesh_->bounds();
  if (!bounds.contains(point)) return false;
  const Vec3d place = (1 / cell_) * (point - bounds.low);
  const auto cell = [](double at, int count) { return std::min(static_cast<int>(at), count - 1); };
  const Side side =
      sides_[index(cell(place.x, count_[0]), cell(place.y, count_[1]), cell(place.z, count_[2]))];
  return side == Side::both ? mesh_->is_inside(point) : side == Side::inside;
}

/// A block that the surface stays away from is of one side; others are halved.
void InsideMap::fill(const Block& block) {
  const auto corner = [this](const int(&n)[3]) {
    return mesh_->bounds().low + cell_ * Vec3d{double(n[0]), double(n[1]), double(n[2])};
  };
  const Vec3d low = corner(block.first), high = corner(block.last);
  const Vec3d centre = 0.5 * (low + high);
  // A hair more than the ball around the block, for rounding.
  if (!mesh_->nearest(centre, 0.501 * norm(high - low)))
    return set(block, mesh_->is_inside(centre) ? Side::inside : Side::outside);
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (block.last[axis] - block.first[axis] > block.last[longest] - block.first[longest])
      longest = axis;
  if (block.last[longest] - block.first[longest] == 1) return;
  Block lower = block, upper = block;
  lower.last[longest] = upper.first[longest] = (block.first[longest] + block.last[longest]) / 2;
  fill(lower);
  fill(upper);
}

void InsideMap::set(const Block& block, Side side) {
  for (int k = block.first[2]; k < block.last[2]; ++k)
    for (int j = block.first[1]; j < block.last[1]; ++j)
      std::fill(sides_.begin() + static_cast<std::ptrdiff_t>(index(block.first[0], j, k)),
                sides_.begin() + static_cast<std::ptrdiff_t>(index(block.last[0], j, k)), side);
}

}  // namespace sabo
