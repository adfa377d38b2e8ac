#include "analysis/volume_ledger.hpp"

#include <algorithm>

namespace sabo {

VolumeLedger::VolumeLedger(double reference_density, const Polyline& dam_axis,
                           const Vec3d& upstream)
    : reference_density_(reference_density),
      dam_(dam_axis),
      downstream_(project(dam_axis, upstream.x, upstream.y).offset >= 0 ? 1 : -1) {}

void VolumeLedger::release(const Particles& particles) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    released_ += particles.mass[i];
    crossings_.resize(std::max<std::size_t>(crossings_.size(), particles.id[i] + 1ul));
  }
}

void VolumeLedger::record(const std::vector<Vec3d>& before, const Places& particles, int threads) {
  if (!dam_) return;
  for (const auto& [i, net] : dam_->crossings(before, particles.position, threads)) {
    int& crossings = crossings_[particles.id[i]];
    const bool was_beyond = crossings > 0;
    crossings += downstream_ * net;
    const bool is_beyond = crossings > 0;
    beyond_ += (is_beyond - was_beyond) * particles.mass[i];
  }
}

void VolumeLedger::leave(const Particles& particles) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    outflow_ += particles.mass[i];
    if (crossings_[particles.id[i]] > 0) beyond_ -= particles.mass[i];
  }
}

bool VolumeLedger::knows(const Particles& particles) const {
  return std::ranges::all_of(particles.id,
                             [this](std::uint32_t id) { return id < crossings_.size(); });
}

VolumeRow VolumeLedger::row() const {
  return {released_ / reference_density_, (released_ - beyond_ - outflow_) / reference_density_,
          beyond_ / reference_density_, outflow_ / reference_density_, put_back_};
}

}  // namespace sabo
