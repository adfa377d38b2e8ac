#include "analysis/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double seconds_a_minute = 60;

void make_room(std::vector<Vec3d>& by_number, const Particles& particles) {
  if (particles.id.empty()) return;
  const std::size_t needed = *std::max_element(particles.id.begin(), particles.id.end()) + 1UL;
  if (by_number.size() < needed) by_number.resize(needed, {unknown, unknown, unknown});
}

}  // namespace

/// Over the particles that are there.
struct RestWatch::Sums {
  double mass = 0;     // kg
  double moving = 0;   // kg
  double path = 0;     // mass x displacement since the start of the window, kg m
  double gone = 0;     // kg further than a spacing from where it was first seen
  double kinetic = 0;  // J
};

RestWatch::RestWatch(const RestLimits& limits, double spacing, double reference_density,
                     double last_start)
    : limits_(limits),
      spacing_(spacing),
      reference_density_(reference_density),
      last_start_(last_start) {}

void RestWatch::update(double time, const Particles& particles) {
  greet(particles);
  if (is_due(time)) keep(time, particles);
  const double age = time - kept_.front().time;
  const Sums sums = sums_over(particles, age);

  state_.moving_volume = sums.moving / reference_density_;
  state_.moving_share = released_ > 0 ? sums.moving / released_ : 0;
  state_.creep =
      age > 0 && sums.mass > 0 ? sums.path / sums.mass / spacing_ / age * seconds_a_minute : 0;
  peak_energy_ = std::max(peak_energy_, sums.kinetic);
  state_.energy_share = peak_energy_ > 0 ? sums.kinetic / peak_energy_ : 0;
  if (state_.energy_share > limits_.energy_share) calm_since_ = time;

  // What has left the domain has moved, too.
  const double moved = sums.gone + released_ - sums.mass;
  state_.has_moved = state_.has_moved || moved > limits_.volume_share * released_;
  state_.is_at_rest = state_.has_moved && has_lasted(age) && has_lasted(time - calm_since_) &&
                      kept_.front().time >= last_start_ &&
                      state_.moving_share <= limits_.volume_share && state_.creep <= limits_.creep;
}

/// As long as rest has to.
bool RestWatch::has_lasted(double duration) const {
  constexpr double rounding = 1e-9;
  return duration >= limits_.time * (1 - rounding);
}

void RestWatch::greet(const Particles& particles) {
  make_room(start_, particles);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Vec3d& start = start_[particles.id[i]];
    if (!std::isnan(start.x)) continue;
    start = particles.position[i];
    released_ += particles.mass[i];
  }
}

void RestWatch::keep(double time, const Particles& particles) {
  Kept now{time, {}};
  make_room(now.position, particles);
  for (std::size_t i = 0; i < particles.size(); ++i)
    now.position[particles.id[i]] = particles.position[i];
  kept_.push_back(std::move(now));
  // The window is the shortest that is long enough.
  while (kept_.size() > 1 && time - kept_[1].time >= limits_.time) kept_.pop_front();
}

RestWatch::Sums RestWatch::sums_over(const Particles& particles, double age) const {
  const Kept& before = kept_.front();
  Sums sums;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double mass = particles.mass[i];
    const std::uint32_t id = particles.id[i];
    const Vec3d& start = start_[id];
    const bool was_there = id < before.position.size() && !std::isnan(before.position[id].x);
    const double path = norm(particles.position[i] - (was_there ? before.position[id] : start));
    sums.mass += mass;
    sums.path += mass * path;
    if (path > limits_.speed * age) sums.moving += mass;
    if (norm(particles.position[i] - start) > spacing_) sums.gone += mass;
    const double speed = norm(particles.velocity[i]);
    sums.kinetic += 0.5 * mass * speed * speed;
  }
  return sums;
}

}  // namespace sabo
