#include "solver/stepper.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace sabo {

Stepper::Stepper(Backend& backend, Domain* domain) : backend_(backend), domain_(domain) {
  if (!domain) return;
  const Surface& ground = domain->ground().surface();
  backend.set_ground_level([&ground](double x, double y) { return ground.height(x, y); });
}

StepReport Stepper::step(double longest) {
  if (particles_changed_) renew_neighbours();
  const StepReport report = advance(longest);
  time_ += report.dt;
  ++steps_;
  const std::vector<BodyLoad>& loads = backend_.body_loads();
  body_impulses_.resize(loads.size());
  for (std::size_t k = 0; k < loads.size(); ++k) body_impulses_[k] += report.dt * loads[k];
  if (domain_ && !domain_->inflows().empty()) advance_inflows(report.dt);
  check_health();
  return report;
}

void Stepper::advance_to(double time, double longest) {
  while (time_ < time) step(std::min(longest, time - time_));
}

void Stepper::advance_inflows(double dt) {
  const Tait& state = backend_.model().state;
  if (domain_->layer_is_due(dt)) {
    backend_.change_rows(domain_->rows_at_inflows(backend_), [&](Particles& near) {
      domain_->advance_inflows(near, state, time_, dt);
    });
    particles_changed_ = true;
  } else {
    backend_.change_driven(
        [&](Particles& driven) { domain_->advance_inflows(driven, state, time_, dt); });
  }
}

void Stepper::renew_neighbours() {
  if (domain_) {
    const PassClock clock(backend_.pass_times(), "ground");
    domain_->update(backend_);
  }
  backend_.find_neighbours();
  particles_changed_ = false;
}

void Stepper::check_health() const {
  const FlowHealth health = backend_.health();
  const std::string when =
      " at t = " + std::to_string(time_) + " s, step " + std::to_string(steps_);
  if (!health.is_finite)
    throw RunError("a position, velocity or density is no longer a finite number" + when +
                   "; try a smaller numerics.cfl and look at the last frame");
  if (health.min_density_ratio < 1 - density_tolerance ||
      health.max_density_ratio > 1 + density_tolerance)
    throw RunError("the density left its range (lowest " +
                   std::to_string(health.min_density_ratio) + ", highest " +
                   std::to_string(health.max_density_ratio) + " of the reference, allowed 1 +- " +
                   std::to_string(density_tolerance) + ")" + when +
                   "; raise numerics.reference_speed to the fastest speed expected, or lower "
                   "numerics.cfl");
}

}  // namespace sabo
