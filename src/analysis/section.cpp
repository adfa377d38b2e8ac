#include "analysis/section.hpp"

namespace sabo {

void Section::record(const Vec3d& from, const Vec3d& to, double volume) {
  add(curtain_.crossings(from, to), volume);
}

void Section::record(const std::vector<Vec3d>& before, const Places& particles,
                     double reference_density, int threads) {
  for (const auto& [row, net] : curtain_.crossings(before, particles.position, threads))
    add(net, particles.mass[row] / reference_density);
}

void Section::add(int net, double volume) {
  if (net == 0) return;
  for (SectionVolumes* volumes : {&total_, &interval_}) {
    (net > 0 ? volumes->forward : volumes->backward) += (net > 0 ? net : -net) * volume;
  }
}

SectionVolumes Section::take_interval() { return std::exchange(interval_, {}); }

}  // namespace sabo
