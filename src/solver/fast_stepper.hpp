#pragma once

#include "solver/stepper.hpp"

namespace sabo {

/// Coefficients of the fast method, see NumericsCase.
struct FastRule {
  double h;                   ///< smoothing length, m
  double cfl;                 ///< C_a
  double sound_speed_factor;  ///< beta
  double slowest_sound;       ///< that of the deepest flow expected, m/s
  double viscous_tolerance;   ///< share of dt g
  int most_iterations;        ///< of the viscous solve before the step is halved
  bool sound_follows_flow;    ///< else it stays at that of the model
};

/// The fast method: viscosity and walls implicit, pressure explicit and symplectic (velocity first,
/// then density and position with the new velocity), a sound speed that follows the flow.
class FastStepper : public Stepper {
 public:
  FastStepper(Backend& backend, const FastRule& rule, Domain* domain);

 protected:
  StepReport advance(double longest) override;

 private:
  void follow_the_flow(double speed);
  VelocityTolerance tolerance() const;

  FastRule rule_;
};

}  // namespace sabo
