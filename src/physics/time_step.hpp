#pragma once

#include <cmath>
#include <limits>
#include <variant>

#include "base/host_device.hpp"
#include "math/scalar.hpp"
#include "physics/switches.hpp"

namespace sabo {

/// The fastest things in the flow, which bound the time step.
struct FlowExtremes {
  double speed = 0;                ///< m/s, of particles that have neighbours
  double acceleration = 0;         ///< m/s2, of the same
  double kinematic_viscosity = 0;  ///< mu_eff / rho, m2/s
};

/// Which of the limits was the smallest.
enum class StepLimit { acoustic, acceleration, viscous };
template <>
struct Words<StepLimit> {
  static constexpr std::array<std::string_view, 3> list{"acoustic", "acceleration", "viscous"};
};

struct TimeStep {
  double dt = 0;  ///< s
  StepLimit limit = StepLimit::acoustic;
};

/// Coefficients of the time step of the method of the paper.
struct TimeStepRule {
  double h;            ///< smoothing length, m
  double c0;           ///< sound speed, m/s
  double cfl;          ///< of the acoustic and the acceleration limit
  double viscous_cfl;  ///< of the viscous limit

  /// min( CFL h / max(c0, 10 v), CFL sqrt(h / a), C_v h^2 / nu ).
  SABO_HD TimeStep operator()(const FlowExtremes& flow) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double acoustic = cfl * h / larger(c0, 10 * flow.speed);
    const double acceleration =
        flow.acceleration > 0 ? cfl * std::sqrt(h / flow.acceleration) : infinity;
    const double viscous =
        flow.kinematic_viscosity > 0 ? viscous_cfl * h * h / flow.kinematic_viscosity : infinity;
    TimeStep step{acoustic, StepLimit::acoustic};
    if (acceleration < step.dt) step = {acceleration, StepLimit::acceleration};
    if (viscous < step.dt) step = {viscous, StepLimit::viscous};
    return step;
  }
  SABO_HD double longest(const FlowExtremes& flow) const { return (*this)(flow).dt; }
};

/// Coefficients of the time step of the fast method, which viscosity does not limit.
struct FastStepRule {
  static constexpr double acceleration_cfl = 0.25;

  double h;            ///< smoothing length, m
  double cfl;          ///< C_a
  double sound_speed;  ///< at present, m/s

  /// min( C_a h / (c + v), sqrt(h / a) / 4 ), s.
  SABO_HD double longest(const FlowExtremes& flow) const {
    const double acoustic = cfl * h / (sound_speed + flow.speed);
    if (!(flow.acceleration > 0)) return acoustic;
    return smaller(acceleration_cfl * std::sqrt(h / flow.acceleration), acoustic);
  }
};

/// A step whose length is given.
struct FixedStep {
  double dt;  ///< s
  SABO_HD double longest(const FlowExtremes& /*flow*/) const { return dt; }
};

using StepRule = std::variant<FixedStep, TimeStepRule, FastStepRule>;

/// Default C_v: four fifths of the measured stability limits of forward Euler, 0.75 h^2/nu for the
/// nested form, twice that for the printed form (it halves the stress), 0.29 for the two-point
/// form.
constexpr double default_viscous_cfl(ViscousOperator op, bool as_printed) {
  if (op == ViscousOperator::morris) return 0.23;
  return as_printed ? 1.2 : 0.6;
}

}  // namespace sabo
