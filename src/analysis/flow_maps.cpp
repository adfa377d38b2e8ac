#include "analysis/flow_maps.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {

FlowMaps::FlowMaps(const Raster& elevation, double spacing, double reference_density)
    : columns_(elevation, spacing, reference_density),
      peak_depth_(elevation.values.size()),
      peak_speed_(elevation.values.size()),
      peak_pressure_(elevation.values.size()),
      peak_momentum_flux_(elevation.values.size()),
      density_(reference_density),
      arrival_time_(elevation.values.size(), Raster::no_data) {}

void FlowMaps::update(double time, const Particles& particles) {
  columns_.update(particles);
  for (const std::size_t cell : columns_.touched()) {
    peak_depth_[cell] = std::max(peak_depth_[cell], columns_.depth(cell));
    if (!columns_.is_wet(cell)) continue;
    peak_speed_[cell] = std::max(peak_speed_[cell], columns_.speed(cell));
    peak_pressure_[cell] = std::max(peak_pressure_[cell], columns_.pressure(cell));
    const double speed = columns_.speed(cell);
    peak_momentum_flux_[cell] =
        std::max(peak_momentum_flux_[cell], density_ * columns_.depth(cell) * speed * speed);
    if (std::isnan(arrival_time_[cell])) arrival_time_[cell] = time;
  }
}

Raster FlowMaps::peak_depth() const { return columns_.masked(peak_depth_); }

Raster FlowMaps::peak_speed() const { return columns_.masked(peak_speed_); }

Raster FlowMaps::peak_pressure() const { return columns_.masked(peak_pressure_); }

Raster FlowMaps::peak_momentum_flux() const { return columns_.masked(peak_momentum_flux_); }

Raster FlowMaps::arrival_time() const { return columns_.masked(arrival_time_); }

Raster FlowMaps::depth() const { return columns_.depth(); }

}  // namespace sabo
