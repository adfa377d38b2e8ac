#include "solver/domain.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace sabo {
namespace {

// A particle between four of a wall may come as near to it as this, in spacings beyond the surface,
// without any of the five being nearer to another than particles usually are.
constexpr double tolerated_depth = 0.1;

}  // namespace

Domain::Domain(Ground& ground, const std::vector<InflowPlan>& inflows, std::uint32_t next_id)
    : ground_(ground), next_id_(next_id) {
  for (const InflowPlan& plan : inflows)
    inflows_.emplace_back(plan, static_cast<std::uint16_t>(inflows_.size() + 1));
}

void Domain::advance_inflows(Particles& fluid, const Tait& state, double time, double dt) {
  for (Inflow& inflow : inflows_) {
    const Inflow::Change change = inflow.advance(fluid, state, time, dt, next_id_);
    entered_.append(fluid, change.entered);
    freed_.append(fluid, change.freed);
  }
}

void Domain::update(Particles& fluid, Particles& boundary, double reach) {
  std::vector<std::uint32_t> staying;
  std::vector<std::uint32_t> leaving;
  staying.reserve(fluid.size());
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d& x = fluid.position[i];
    const bool stays = ground_.surface().inside(x.x, x.y);
    (stays ? staying : leaving).push_back(static_cast<std::uint32_t>(i));
    if (stays && fluid.driven[i] == 0 && ground_.is_solid(x)) put_back(fluid, i);
  }
  if (!leaving.empty()) {
    departed_.append(fluid, leaving);
    fluid.permute(staying);
  }
  ground_.follow(fluid.position, reach, boundary);
}

void Domain::put_back(Particles& fluid, std::size_t i) {
  const Vec3d way_out = ground_.pushed_out(fluid.position[i]) - fluid.position[i];
  if (norm(way_out) < tolerated_depth * ground_.spacing()) return;
  fluid.position[i] += way_out;
  // It may slide on, but not back in.
  const double inward = std::min(0.0, dot(fluid.velocity[i], way_out));
  fluid.velocity[i] -= (inward / dot(way_out, way_out)) * way_out;
  ++put_back_count_;
}

Particles Domain::take_departed() { return std::exchange(departed_, {}); }

Particles Domain::take_entered() { return std::exchange(entered_, {}); }

Particles Domain::take_freed() { return std::exchange(freed_, {}); }

}  // namespace sabo
