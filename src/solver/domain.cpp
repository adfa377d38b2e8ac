#include "solver/domain.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/host_loops.hpp"

namespace sabo {

Domain::Domain(Ground& ground, const std::vector<InflowPlan>& inflows, std::uint32_t next_id)
    : ground_(ground), next_id_(next_id) {
  for (const InflowPlan& plan : inflows)
    inflows_.emplace_back(plan, static_cast<std::uint16_t>(inflows_.size() + 1));
}

ParticleRows Domain::rows_at_inflows(Backend& backend) const {
  const std::span<const Vec3d> positions = backend.positions();
  std::vector<char> is_seen(positions.size());
  over(positions.size(), host_threads(backend.model().threads), [&](std::size_t i) {
    is_seen[i] = std::ranges::any_of(
        inflows_, [&](const Inflow& inflow) { return inflow.may_be_in_the_way(positions[i]); });
  });
  for (const std::uint32_t row : backend.driven_rows()) is_seen[row] = 1;
  ParticleRows rows;
  for (std::uint32_t i = 0; i < is_seen.size(); ++i)
    if (is_seen[i]) rows.push_back(i);
  return rows;
}

void Domain::advance_inflows(Particles& fluid, const Tait& state, double time, double dt) {
  for (Inflow& inflow : inflows_) {
    const Inflow::Change change = inflow.advance(fluid, state, time, dt, next_id_);
    entered_.append(fluid, change.entered);
    freed_.append(fluid, change.freed);
  }
}

void Domain::update(Backend& backend) {
  const std::span<const Vec3d> positions = backend.positions();
  std::vector<Place> places(positions.size());
  const int threads = backend.model().threads;
  over(positions.size(), host_threads(threads),
       [&](std::size_t i) { places[i] = place_of(positions[i]); });
  ParticleRows leaving, sunk;
  std::vector<Vec3d> ways_out;  // m
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places[i] == Place::outside) leaving.push_back(i);
    if (places[i] != Place::solid) continue;
    const Vec3d way_out = ground_.pushed_out(positions[i]) - positions[i];
    if (norm(way_out) < tolerated_depth * ground_.spacing()) continue;
    sunk.push_back(i);
    ways_out.push_back(way_out);
  }
  if (!sunk.empty()) put_back(backend, sunk, ways_out);
  if (!leaving.empty()) departed_.append(backend.take_out(leaving));
  // Beside the flow as far as structures do not feel it any more, see LoadProfile.
  const bool has_structures = !ground_.dams().empty() || !ground_.bodies().empty();
  const double reach = backend.list_radius() + (has_structures ? ground_.spacing() : 0);
  const BoundaryChange change = ground_.follow(backend.positions(), reach, threads);
  if (!change.is_empty()) backend.change_boundary(change);
}

Domain::Place Domain::place_of(const Vec3d& x) const {
  if (!ground_.surface().inside(x.x, x.y)) return Place::outside;
  return ground_.is_solid(x) ? Place::solid : Place::free;
}

void Domain::put_back(Backend& backend, const ParticleRows& sunk,
                      const std::vector<Vec3d>& ways_out) {
  backend.change_rows(sunk, [&](Particles& found) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (found.driven[k] != 0) continue;
      const Vec3d& way_out = ways_out[k];
      found.position[k] += way_out;
      // It may slide on, but not back in.
      Vec3d& velocity = found.velocity[k];
      const double inward = std::min(0.0, dot(velocity, way_out));
      velocity -= (inward / dot(way_out, way_out)) * way_out;
      ++put_back_count_;
    }
  });
}

Particles Domain::take_departed() { return std::exchange(departed_, {}); }

Particles Domain::take_entered() { return std::exchange(entered_, {}); }

Particles Domain::take_freed() { return std::exchange(freed_, {}); }

}  // namespace sabo
