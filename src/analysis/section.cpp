#include "analysis/section.hpp"

namespace sabo {

void Section::record(const Vec3d& from, const Vec3d& to, double volume) {
  const int net = curtain_.crossings(from, to);
  if (net == 0) return;
  for (SectionVolumes* volumes : {&total_, &interval_}) {
    (net > 0 ? volumes->forward : volumes->backward) += (net > 0 ? net : -net) * volume;
  }
}

void Section::record(const std::vector<Vec3d>& before, const Particles& particles,
                     double reference_density) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    record(before[i], particles.position[i], particles.mass[i] / reference_density);
  }
}

SectionVolumes Section::take_interval() { return std::exchange(interval_, {}); }

}  // namespace sabo
