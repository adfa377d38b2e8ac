#include "solver/fast_stepper.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double sound_decay = 0.98;  // per step, so that one impact is soon forgotten
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
  backend_.fix_step(0);
  backend_.advance_state();
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
  report.sound_speed = backend_.model().state.c0;
  backend_.choose_step(FastStepRule{rule_.h, rule_.cfl, report.sound_speed}, longest);
  for (int halvings = 0;; ++halvings) {
    const ViscousSolve solve = backend_.advance_velocity(tolerance(), rule_.most_iterations);
    report.iterations += solve.iterations;
    if (solve.converged) break;
    if (halvings == most_halvings)
      throw RunError(
          "the implicit viscosity does not converge; raise numerics.viscous_iterations, "
          "or lower material.viscosity_ratio");
    backend_.fix_step(backend_.chosen_step().dt / 2);
  }
  backend_.near_motion();
  backend_.advance_state();
  const ChosenStep step = backend_.chosen_step();
  report.dt = step.dt;
  report.flow = step.flow;
  return report;
}

/// A share of what gravity changes; without gravity of what the greatest acceleration does.
VelocityTolerance FastStepper::tolerance() const {
  const double gravity = norm(backend_.model().gravity);
  if (gravity > 0) return {.rate = rule_.viscous_tolerance * gravity};
  return {.share = rule_.viscous_tolerance};
}

void FastStepper::follow_the_flow(double speed) {
  if (!rule_.sound_follows_flow) return;
  const double wanted = std::max(rule_.slowest_sound, rule_.sound_speed_factor * speed);
  const double present = backend_.model().state.c0;
  const double next = std::max(wanted, sound_decay * present);
  if (next != present) backend_.set_sound_speed(next);
}

}  // namespace sabo
