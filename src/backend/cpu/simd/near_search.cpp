// Compiled once for each instruction set, as pair_sweeps.cpp is.

#include "backend/cpu/simd/near_search.hpp"

#include "backend/cpu/simd/picked.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

std::size_t near_search(const NearTask& task) {
  const Lanes::Tag floats;
  const hn::RebindToUnsigned<Lanes::Tag> indices;
  const hn::RebindToSigned<Lanes::Tag> lanes;
  // Made once: GCC 12 writes hn::Iota entry by entry, and hn::FirstN as picked.hpp says.
  const auto lane = hn::Iota(lanes, 0);
  const auto self = hn::Set(indices, task.self);
  const Lanes x(task.x), y(task.y), z(task.z), radius2(task.radius2);
  const float *const points_x = task.points_x, *const points_y = task.points_y,
                     *const points_z = task.points_z;
  std::uint32_t* near_end = task.near;
  for (int r = 0; r < task.run_count; ++r) {
    const IndexRun run = task.runs[r];
    for (std::uint32_t j = run.first; j < run.last; j += Lanes::count) {
      const Lanes dx = x - Lanes(hn::LoadU(floats, points_x + j));
      const Lanes dy = y - Lanes(hn::LoadU(floats, points_y + j));
      const Lanes dz = z - Lanes(hn::LoadU(floats, points_z + j));
      const Lanes r2 = dx * dx + dy * dy + dz * dz;
      const auto index = hn::Add(hn::BitCast(indices, lane), hn::Set(indices, task.offset + j));
      const auto is_other = hn::RebindMask(floats, hn::Ne(index, self));
      const auto is_near = hn::And(hn::Lt(r2.v, radius2.v), is_other);
      const auto in_run = hn::Lt(lane, hn::Set(lanes, static_cast<std::int32_t>(run.last - j)));
      const Picked near(hn::And(is_near, hn::RebindMask(floats, in_run)));
      near.store(indices, index, near_end);
      near_end += near.count();
    }
  }
  return static_cast<std::size_t>(near_end - task.near);
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
