#include "solver/flow_model.hpp"

#include <algorithm>
#include <cmath>

#include "math/angle.hpp"

namespace sabo {
namespace {

WallShear wall_shear(const NumericsCase& numerics) {
  const double slope = std::tan(numerics.wall_friction_angle * degree);
  const Coulomb friction{numerics.wall_cohesion, slope};
  switch (numerics.wall) {
    case WallLaw::coulomb:
      return friction;
    case WallLaw::voellmy:
      return Voellmy{friction, numerics.wall_turbulence};
    case WallLaw::slip:
      return Slip{};
    case WallLaw::no_slip:
      break;
  }
  return NoSlip{};
}

/// Grains that fly apart push each other only, and the noise of pressure then drives the front of a
/// slump: columns of grains ran out 40 % too far (docs/method.md, Tension).
bool bears_tension(TensionAtSurface tension, const Rheology& law) {
  return tension == TensionAtSurface::by_law ? has_yield(law) : tension == TensionAtSurface::borne;
}

/// Where the viscous stress is of the order of the pressure, as by laws with a yield stress, it
/// disorders a flow that shears; water is better without so much shifting (docs/method.md).
double shifting(const NumericsCase& numerics, const Rheology& law) {
  if (numerics.method == Method::paper) return 0;
  return numerics.particle_shifting.value_or(has_yield(law) ? 40 : 20);
}

}  // namespace

FlowModel flow_model(const MaterialCase& material, const NumericsCase& numerics,
                     double release_depth) {
  const double depth = numerics.h_max.value_or(release_depth);
  const double speed = std::max(std::sqrt(numerics.gravity * depth), numerics.reference_speed);
  FlowModel model;
  model.spacing = numerics.spacing;
  model.h = numerics.h_over_dp * numerics.spacing;
  model.state = {material.density, numerics.sound_speed_factor * speed};
  model.gravity = {0, 0, -numerics.gravity};
  model.rheology = material.law;
  model.yield = material.yield;
  model.density_diffusion = numerics.density_diffusion;
  model.diffusion_form = numerics.diffusion_form;
  model.artificial_viscosity = numerics.artificial_viscosity;
  model.viscous_operator = numerics.viscous_operator;
  model.boundary_stress = numerics.boundary_stress;
  model.boundary_pressure = numerics.boundary_pressure;
  model.wall = wall_shear(numerics);
  model.crowding_tolerance = numerics.crowding_tolerance;
  model.tension_at_surface =
      numerics.method == Method::paper || bears_tension(numerics.tension_at_surface, material.law);
  model.particle_shifting = shifting(numerics, material.law);
  model.whole_viscous_stress = has_yield(material.law);  // docs/method.md, F3
  if (numerics.method == Method::fast && has_yield(material.law))
    model.sleep = {numerics.sleep_speed, numerics.sleep_time};
  model.as_printed = numerics.as_printed;
  model.threads = numerics.threads;
  return model;
}

FastRule fast_rule(const NumericsCase& numerics, const FlowModel& model) {
  return {.h = model.h,
          .cfl = numerics.cfl,
          .sound_speed_factor = numerics.sound_speed_factor,
          .slowest_sound = model.state.c0,
          .viscous_tolerance = numerics.viscous_tolerance,
          .most_iterations = numerics.viscous_iterations,
          .sound_follows_flow = numerics.adaptive_sound_speed};
}

TimeStepRule time_step_rule(const NumericsCase& numerics, const FlowModel& model) {
  const double viscous_cfl =
      numerics.viscous_cfl.value_or(default_viscous_cfl(model.viscous_operator, model.as_printed));
  return {model.h, model.state.c0, numerics.cfl, viscous_cfl};
}

}  // namespace sabo
