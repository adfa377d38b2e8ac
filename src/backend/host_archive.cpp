#include <algorithm>
#include <cmath>

#include "backend/host_backend.hpp"

// What of a backend outlives a step. Pairs are not kept but listed again from where the particles
// were when they were listed: the same list in the same order, hence the same sums.

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

template <class Archive>
void HostBackend::archive_state(Archive& a) {
  std::vector<Vec3d> listed = listed_positions();
  a.mark("backend");
  a(model_.state.c0, fluid_);  // as ArchivedFluid
  a(boundary_, awake_, body_loads_, body_forces_, numerical_heat_, pass_times_, listed);
  if constexpr (Archive::is_reader) list_again(listed);
}

template void HostBackend::archive_state(ArchiveWriter&);
template void HostBackend::archive_state(ArchiveReader&);

void HostBackend::list_again(std::vector<Vec3d>& listed) {
  const std::size_t count = fluid_.size();
  if (listed.size() != count || !is_sane(listed, list_radius()) ||
      !is_sane(boundary_.position, list_radius()) || !is_sane(fluid_.position, list_radius()))
    throw RunError("holds particles in impossible places");
  const std::vector<std::uint32_t> awake = awake_;
  for (std::size_t k = 0; k < awake.size(); ++k)
    if (awake[k] >= count || (k > 0 && awake[k] <= awake[k - 1]))
      throw RunError("holds rows of particles that there are not");
  const std::vector<BodyForce> forces = body_forces_;
  const PassTimes times = pass_times_;
  fluid_.position.swap(listed);
  find_neighbours();
  fluid_.position.swap(listed);
  if (forces.size() != body_forces_.size()) throw RunError("holds forces on other bodies");
  body_forces_ = forces;
  if (awake.size() + driven_.size() > count)
    throw RunError("holds more particles awake than there are");
  awake_ = awake;
  asleep_count_ = count - awake_.size() - driven_.size();
  prepare_rows();
  pass_times_ = times;
}

}  // namespace sabo
