// Compiled once for each instruction set, as pair_sweeps.cpp is.

#include "backend/cpu/simd/near_search.hpp"

namespace sabo {
namespace HWY_NAMESPACE {

std::size_t near_search(const NearTask& task) {
  const Lanes::Tag floats;
  const hn::RebindToUnsigned<Lanes::Tag> indices;
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
      const auto is_near =
          hn::And(hn::RebindMask(indices, hn::Lt(r2.v, radius2.v)), hn::Not(hn::Eq(index, self)));
      const auto is_in_run = hn::FirstN(indices, run.last - j);
      count += store_picked(indices, index, hn::And(is_near, is_in_run), task.near + count);
    }
  }
  return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace sabo
