#include "solver/paper_stepper.hpp"

namespace sabo {

PaperStepper::PaperStepper(Backend& backend, const TimeStepRule& rule, Domain* domain)
    : Stepper(backend, domain), rule_(rule) {
  renew_neighbours();
  backend_.pressure();
  backend_.extrapolate_to_boundary();
}

StepReport PaperStepper::advance(double longest) {
  // dt v is at most CFL h / 10, half of it before the middle of the step.
  const double half_step = 0.05 * rule_.cfl * rule_.h;
  if (backend_.neighbours_are_stale(half_step)) renew_neighbours();

  evaluate();
  backend_.choose_step(rule_, longest);
  backend_.predict();
  evaluate();
  backend_.correct();
  const ChosenStep step = backend_.chosen_step();
  return {.dt = step.dt, .flow = step.flow, .sound_speed = rule_.c0};
}

void PaperStepper::evaluate() {
  backend_.pressure();
  if (backend_.model().boundary_pressure == BoundaryPressure::extrapolated)
    backend_.wall_pressure();
  backend_.strain_and_density_rates();
  backend_.stress();
  backend_.momentum();
}

}  // namespace sabo
