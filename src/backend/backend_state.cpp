#include "backend/backend_state.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace sabo {
namespace {

// No flow spreads over more lattice columns than this; damaged positions would.
constexpr double most_columns = 1e9;

bool is_sane(const std::vector<Vec3d>& positions, double width) {
  if (positions.empty()) return true;
  Vec3d low = positions.front(), high = low;
  for (const Vec3d& x : positions) {
    if (!std::isfinite(x.x + x.y + x.z)) return false;
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  const double farthest = std::max({norm(low), norm(high)}) / width;
  return (1 + (high.x - low.x) / width) * (1 + (high.y - low.y) / width) < most_columns &&
         farthest < most_columns;
}

}  // namespace

void BackendState::check(double list_radius) const {
  if (listed.size() != fluid.size() || !is_sane(listed, list_radius) ||
      !is_sane(boundary.position, list_radius) || !is_sane(fluid.position, list_radius))
    throw RunError("holds particles in impossible places");
  for (std::size_t k = 0; k < awake.size(); ++k)
    if (awake[k] >= fluid.size() || (k > 0 && awake[k] <= awake[k - 1]))
      throw RunError("holds rows of particles that there are not");
}

}  // namespace sabo
