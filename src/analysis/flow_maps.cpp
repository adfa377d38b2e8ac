#include "analysis/flow_maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {

FlowMaps::FlowMaps(const Raster& elevation, double spacing, double reference_density)
    : spreader_(elevation, spacing),
      reference_density_(reference_density),
      volume_(elevation.values.size()),
      transport_(elevation.values.size()),
      peak_depth_(elevation.values.size()),
      peak_speed_(elevation.values.size()),
      arrival_time_(elevation.values.size(), Raster::no_data) {}

void FlowMaps::update(double time, const Particles& particles) {
  for (const std::size_t cell : touched_) volume_[cell] = transport_[cell] = 0;
  touched_.clear();

  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double volume = particles.mass[i] / reference_density_;
    const double speed = norm(particles.velocity[i]);
    spreader_.spread(particles.position[i].x, particles.position[i].y,
                     [&](std::size_t cell, double share) {
                       if (volume_[cell] == 0) touched_.push_back(cell);
                       volume_[cell] += share * volume;
                       transport_[cell] += share * volume * speed;
                     });
  }

  for (const std::size_t cell : touched_) {
    const double depth = volume_[cell] / spreader_.grid().cell_area();
    peak_depth_[cell] = std::max(peak_depth_[cell], depth);
    if (!(depth > wet_depth)) continue;
    peak_speed_[cell] = std::max(peak_speed_[cell], transport_[cell] / volume_[cell]);
    if (std::isnan(arrival_time_[cell])) arrival_time_[cell] = time;
  }
}

Raster FlowMaps::masked(const std::vector<double>& values) const {
  Raster map(spreader_.grid());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    map.values[cell] = spreader_.is_inside(cell) ? values[cell] : Raster::no_data;
  }
  return map;
}

Raster FlowMaps::peak_depth() const { return masked(peak_depth_); }

Raster FlowMaps::peak_speed() const { return masked(peak_speed_); }

Raster FlowMaps::arrival_time() const { return masked(arrival_time_); }

Raster FlowMaps::depth() const {
  Raster map = masked(volume_);
  for (double& value : map.values) value /= map.grid.cell_area();
  return map;
}

}  // namespace sabo
