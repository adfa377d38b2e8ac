#include "analysis/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/host_loops.hpp"

namespace sabo {

const std::vector<Vec3d>& Tracks::advance(const Places& particles, int threads) {
  if (!particles.id.empty()) {
    const std::size_t needed = *std::max_element(particles.id.begin(), particles.id.end()) + 1ul;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    if (last_.size() < needed) last_.resize(needed, {unknown, unknown, unknown});
  }
  before_.resize(particles.size());
  over(particles.size(), host_threads(threads), [&](std::size_t i) {
    Vec3d& last = last_[particles.id[i]];
    before_[i] = std::isnan(last.x) ? particles.position[i] : last;
    last = particles.position[i];
  });
  return before_;
}

}  // namespace sabo
