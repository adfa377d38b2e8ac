#pragma once

#include <algorithm>

#include "backend/model.hpp"

namespace sabo {

/// Share of a negative pressure that a particle bears, by the share of its kernel that has
/// neighbours: the two outer rows of a flow have less than 0.9, those inside more than 0.95.
SABO_HD inline double borne_tension(const FlowModel& model, double support) {
  constexpr double none = 0.9, all = 0.95;
  return model.tension_at_surface ? 1 : std::clamp((support - none) / (all - none), 0.0, 1.0);
}

/// Pressure of a density, and the energy that it stores in a mass, J/kg, where a share of tension
/// is borne: what is torn neither pulls nor stores anything.
SABO_HD inline double borne_pressure(const Tait& state, double density, double borne) {
  const double pressure = state.pressure(density);
  return pressure < 0 ? borne * pressure : pressure;
}
SABO_HD inline double borne_energy(const Tait& state, double density, double borne) {
  const double energy = state.elastic_energy(density);
  return density < state.rho0 ? borne * energy : energy;
}

/// Mean of p / rho^2 over a change of density: what it stores in a mass is this times the change.
SABO_HD inline double borne_mean(const Tait& state, double before, double after, double borne) {
  const bool has_kink = borne < 1 && (before < state.rho0) != (after < state.rho0);
  if (has_kink)
    return (borne_energy(state, after, borne) - borne_energy(state, before, borne)) /
           (after - before);
  const double middle = 0.5 * (before + after);
  return borne_pressure(state, middle, borne) / (middle * middle);
}

}  // namespace sabo
