#include "analysis/columns.hpp"

#include <algorithm>

namespace sabo {

Columns::Columns(const Raster& elevation, double spacing, double reference_density)
    : spreader_(elevation, spacing),
      reference_density_(reference_density),
      wet_depth_(wet_depth(spacing)),
      volume_(elevation.values.size()),
      transport_(elevation.values.size()),
      pressure_(elevation.values.size()) {}

void Columns::update(const Particles& particles) {
  for (const std::size_t cell : touched_) volume_[cell] = transport_[cell] = pressure_[cell] = 0;
  touched_.clear();

  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double volume = particles.mass[i] / reference_density_;
    const double speed = norm(particles.velocity[i]);
    spreader_.spread(particles.position[i].x, particles.position[i].y,
                     [&](std::size_t cell, double share) {
                       if (volume_[cell] == 0) touched_.push_back(cell);
                       volume_[cell] += share * volume;
                       transport_[cell] += share * volume * speed;
                       pressure_[cell] = std::max(pressure_[cell], particles.pressure[i]);
                     });
  }
}

Raster Columns::masked(const std::vector<double>& values) const {
  Raster map(spreader_.grid());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    map.values[cell] = spreader_.is_inside(cell) ? values[cell] : Raster::no_data;
  }
  return map;
}

template <class Value>
Raster Columns::wet(const Value& value) const {
  std::vector<double> values(volume_.size());
  for (const std::size_t cell : touched_) {
    if (is_wet(cell)) values[cell] = value(cell);
  }
  return masked(values);
}

Raster Columns::depth() const {
  Raster map = masked(volume_);
  for (double& value : map.values) value /= map.grid.cell_area();
  return map;
}

Raster Columns::speed() const {
  return wet([this](std::size_t cell) { return speed(cell); });
}

Raster Columns::pressure() const {
  return wet([this](std::size_t cell) { return pressure(cell); });
}

}  // namespace sabo
