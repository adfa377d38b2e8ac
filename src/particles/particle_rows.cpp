#include "particles/particle_rows.hpp"

#include <numeric>

namespace sabo {
namespace {

/// The rows of `count` that are not among these.
ParticleRows rows_beside(const ParticleRows& rows, std::size_t count) {
  ParticleRows beside;
  beside.reserve(count - rows.size());
  auto next = rows.begin();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (next != rows.end() && *next == i)
      ++next;
    else
      beside.push_back(i);
  }
  return beside;
}

}  // namespace

Particles take_tail(Particles& from, std::size_t count) {
  ParticleRows rows(from.size() - count);
  std::iota(rows.begin(), rows.end(), static_cast<std::uint32_t>(count));
  Particles tail;
  tail.append(from, rows);
  from.resize(count);
  return tail;
}

void change_rows(Particles& all, const ParticleRows& rows,
                 const std::function<void(Particles&)>& change) {
  Particles some;
  some.append(all, rows);
  change(some);
  const Particles added = take_tail(some, rows.size());
  all.put(some, rows);
  all.append(added);
}

Particles take_out(Particles& all, const ParticleRows& rows) {
  Particles taken;
  taken.append(all, rows);
  all.permute(rows_beside(rows, all.size()));
  return taken;
}

}  // namespace sabo
