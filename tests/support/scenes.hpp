#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "backend/backend.hpp"
#include "case/default_numerics.hpp"
#include "solver/fast_stepper.hpp"
#include "solver/flow_model.hpp"
#include "solver/lattice.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"
#include "solver/paper_stepper.hpp"

namespace sabo::test {

using sabo::add_block;
using sabo::add_particle;
using sabo::Cells;
using sabo::Layer;
using sabo::make_hydrostatic;

inline constexpr double g = 9.81;  ///< m/s2

inline double mass_of(const Particles& particles) {
  return std::accumulate(particles.mass.begin(), particles.mass.end(), 0.0);
}

/// Water-like, in three dimensions: for tests that are not about a material.
inline FlowModel plain_model(double spacing, double sound_speed, double viscosity) {
  FlowModel model;
  model.spacing = spacing;
  model.h = 1.5 * spacing;
  model.state = {1000, sound_speed};
  model.rheology = Newtonian{viscosity};
  model.threads = 1;
  return model;
}

/// The time step rules of the cases, for a model set up by hand.
inline TimeStepRule rule_of(const FlowModel& model) {
  return time_step_rule(default_numerics(Method::paper), model);
}
inline FastRule fast_rule_of(const FlowModel& model) {
  return fast_rule(default_numerics(Method::fast), model);
}

/// A stepper of either method for a model set up by hand.
inline std::unique_ptr<Stepper> stepper_of(Method method, Backend& backend,
                                           Domain* domain = nullptr) {
  return make_stepper(default_numerics(method), backend, domain);
}

/// Power that viscosity takes at the last evaluation by the method of the paper, W: by the heat of
/// a step of 1e-12 s. Of a flow that has had no other step.
inline double dissipated_power(Backend& backend) {
  constexpr double dt = 1e-12;
  const double before = backend.heat().viscosity;
  backend.fix_step(dt);
  backend.predict();
  backend.correct();
  return (backend.heat().viscosity - before) / dt;
}

inline constexpr Method both_methods[] = {Method::fast, Method::paper};

}  // namespace sabo::test
