// Compiled once for each instruction set, as pair_sweeps.cpp is.

#include "backend/cpu/simd/near_search.hpp"

#include "backend/cpu/simd/picked.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

std::size_t near_search(const NearTask& task) {
  const Lanes::Tag floats;
  const hn::RebindToUnsigned<Lanes::Tag> indices;
  const hn::RebindToSigned<Lanes::Tag> lanes;
  const auto lane = hn::Iota(lanes, 0);  // hn::FirstN of Highway 1.0 copies a table, see picked.hpp
  const auto self = hn::Set(indices, task.self);
  const Lanes x(task.x), y(task.y), z(task.z), radius2(task.radius2);
  std::size_t count = 0;
  for (int r = 0; r < task.run_count; ++r) {
    const IndexRun run = task.runs[r];
    for (std::uint32_t j = run.first; j < run.last; j += Lanes::count) {
      const Lanes dx = x - Lanes(hn::LoadU(floats, task.points_x + j));
      const Lanes dy = y - Lanes(hn::LoadU(floats, task.points_y + j));
      const Lanes dz = z - Lanes(hn::LoadU(floats, task.points_z + j));
      const Lanes r2 = dx * dx + dy * dy + dz * dz;
      const auto index = hn::Iota(indices, task.offset + j);
      const auto is_other = hn::RebindMask(floats, hn::Ne(index, self));
      const auto is_near = hn::And(hn::Lt(r2.v, radius2.v), is_other);
      const auto in_run = hn::Lt(lane, hn::Set(lanes, static_cast<std::int32_t>(run.last - j)));
      const Picked near(hn::And(is_near, hn::RebindMask(floats, in_run)));
      near.store(indices, index, task.near + count);
      count += near.count();
    }
  }
  return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
