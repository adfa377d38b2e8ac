#include "analysis/section_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sabo {

SectionSlab::SectionSlab(Polyline line, double spacing, double reference_density)
    : line_(std::move(line)),
      length_(length(line_)),
      spacing_(spacing),
      density_(reference_density) {}

SectionState SectionSlab::measure(const Surface& ground, const Particles& particles) const {
  const double half = 2 * spacing_;
  // As many as come nearest to two spacings each.
  const double strips = std::max(1.0, std::round(length_ / (2 * spacing_)));
  const double strip = length_ / strips;
  std::vector<double> volume_of_strip(static_cast<std::size_t>(strips), 0.0);
  SectionState state;
  double volume = 0, transport = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3d& x = particles.position[i];
    const LinePlace place = project(line_, x.x, x.y);
    if (std::abs(place.offset) > half || place.station < 0 || place.station > length_) continue;
    const Vec3d along = direction_at(line_, place.station);
    const Vec3d to_the_right{along.y, -along.x, 0};
    const double share = particles.mass[i] / density_;
    const double speed = dot(particles.velocity[i], to_the_right);
    volume += share;
    transport += share * speed;
    state.greatest_speed = std::max(state.greatest_speed, std::abs(speed));
    const auto at = static_cast<std::size_t>(place.station / strip);
    volume_of_strip[std::min(at, volume_of_strip.size() - 1)] += share;
    const double height = std::max(0.0, x.z - ground.height(x.x, x.y));
    const auto layer = static_cast<std::size_t>(height / spacing_);
    if (layer >= state.layers.size()) state.layers.resize(layer + 1);
    state.layers[layer].area += share / (2 * half);
    state.layers[layer].speed += share / (2 * half) * speed;
  }
  state.area = volume / (2 * half);
  state.mean_speed = volume > 0 ? transport / volume : 0;
  for (const double in_strip : volume_of_strip)
    state.depth = std::max(state.depth, in_strip / (2 * half * strip));
  for (std::size_t k = 0; k < state.layers.size(); ++k) {
    SectionState::Layer& layer = state.layers[k];
    layer.height = (static_cast<double>(k) + 0.5) * spacing_;
    layer.speed = layer.area > 0 ? layer.speed / layer.area : 0;
  }
  return state;
}

}  // namespace sabo
