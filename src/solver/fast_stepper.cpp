#include "solver/fast_stepper.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double sound_decay = 0.98;  // per step, so that one impact is soon forgotten
constexpr double acceleration_cfl = 0.25;
constexpr int most_halvings = 20;
constexpr std::size_t sleep_interval = 16;  // steps

}  // namespace

FastStepper::FastStepper(Backend& backend, const FastRule& rule, Domain* domain)
    : Stepper(backend, domain), rule_(rule) {
  // The first step needs the viscosity of the flow as it is.
  renew_neighbours();
  backend_.pressure();
  backend_.wall_pressure();
  backend_.near_forces();
  backend_.wall_resistance();
  backend_.near_motion();
  backend_.advance_state(0);
}

StepReport FastStepper::advance(double longest) {
  if (steps() % sleep_interval == 0) backend_.update_sleep();
  // All sums are taken where the particles are now.
  if (backend_.neighbours_are_stale(0)) renew_neighbours();
  follow_the_flow(backend_.fastest());

  backend_.wall_pressure();
  backend_.near_forces();
  backend_.wall_resistance();

  StepReport report;
  report.flow = backend_.extremes();
  report.sound_speed = backend_.model().state.c0;
  report.dt = std::min(longest_step(report.flow), longest);
  const double gravity = norm(backend_.model().gravity);
  for (int halvings = 0;; ++halvings) {
    // Without gravity: what the fastest acceleration changes.
    const double change = report.dt * (gravity > 0 ? gravity : report.flow.acceleration);
    const ViscousSolve solve = backend_.advance_velocity(
        report.dt, rule_.viscous_tolerance * change, rule_.most_iterations);
    report.iterations += solve.iterations;
    if (solve.converged) break;
    if (halvings == most_halvings)
      throw RunError(
          "the implicit viscosity does not converge; raise numerics.viscous_iterations, "
          "or lower material.viscosity_ratio");
    report.dt /= 2;
  }
  backend_.near_motion();
  backend_.advance_state(report.dt);
  return report;
}

void FastStepper::follow_the_flow(double speed) {
  if (!rule_.sound_follows_flow) return;
  const double wanted = std::max(rule_.slowest_sound, rule_.sound_speed_factor * speed);
  const double present = backend_.model().state.c0;
  const double next = std::max(wanted, sound_decay * present);
  if (next != present) backend_.set_sound_speed(next);
}

double FastStepper::longest_step(const FlowExtremes& flow) const {
  double dt = rule_.cfl * rule_.h / (backend_.model().state.c0 + flow.speed);
  if (flow.acceleration > 0)
    dt = std::min(dt, acceleration_cfl * std::sqrt(rule_.h / flow.acceleration));
  return dt;
}

}  // namespace sabo
