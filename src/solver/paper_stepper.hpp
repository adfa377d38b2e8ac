#pragma once

#include "solver/stepper.hpp"

namespace sabo {

/// The paper's time step: predictor-corrector with the rates at the middle of the step.
class PaperStepper : public Stepper {
 public:
  PaperStepper(Backend& backend, const TimeStepRule& rule, Domain* domain);

 protected:
  StepReport advance(double longest) override;

 private:
  void evaluate();

  TimeStepRule rule_;
};

}  // namespace sabo
