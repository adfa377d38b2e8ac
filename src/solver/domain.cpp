#include "solver/domain.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace sabo {

void Domain::update(Particles& fluid, Particles& boundary, double reach) {
  std::vector<std::uint32_t> staying;
  std::vector<std::uint32_t> leaving;
  staying.reserve(fluid.size());
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d& x = fluid.position[i];
    const bool stays = ground_.surface().inside(x.x, x.y);
    (stays ? staying : leaving).push_back(static_cast<std::uint32_t>(i));
    if (stays && ground_.is_solid(x)) {
      fluid.position[i] = ground_.pushed_out(x);
      fluid.velocity[i] = {};
      ++put_back_count_;
    }
  }
  if (!leaving.empty()) {
    departed_.append(fluid, leaving);
    fluid.permute(staying);
  }
  ground_.follow(fluid.position, reach, boundary);
}

Particles Domain::take_departed() { return std::exchange(departed_, {}); }

}  // namespace sabo
