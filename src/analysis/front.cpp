#include "analysis/front.hpp"

namespace sabo {

FrontRow Front::update(double time, const Particles& particles) {
  const double position =
      index_.foremost(particles.position, particles.mass, share).value_or(last_position_);
  FrontRow row{position, 0, 0};
  if (start_) {
    row.displacement = position - *start_;
    if (time > last_time_) row.velocity = (position - last_position_) / (time - last_time_);
  } else if (particles.size() > 0) {
    start_ = position;
  }
  last_time_ = time;
  last_position_ = position;
  return row;
}

}  // namespace sabo
