#pragma once

#include "support/scenes.hpp"

#include "backend/reference/reference_backend.hpp"

// One implicit step of velocity by itself.

namespace sabo::test {

/// The oracle, with what it knows of the walls laid open.
struct OpenedReference : ReferenceBackend {
  using HostBackend::wall_drag_;
  using HostBackend::wall_share_;
  using ReferenceBackend::ReferenceBackend;
};

inline FlowModel viscous(double viscosity) {
  FlowModel model = test::plain_model(0.1, 20, viscosity);
  model.gravity = {};
  return model;
}

inline void set_viscosity(Particles& fluid, double viscosity) {
  fluid.viscosity.assign(fluid.size(), viscosity);
}

/// Everything before the solve.
inline void prepare(Backend& backend) {
  backend.find_neighbours();
  backend.pressure();
  backend.wall_pressure();
  backend.near_forces();
  backend.wall_resistance();
}

/// The solve by itself, to a residual of `tolerance` (m/s).
inline ViscousSolve advance_velocity(Backend& backend, double dt, double tolerance,
                                     int most_iterations) {
  backend.fix_step(dt);
  return backend.advance_velocity({.rate = tolerance / dt}, most_iterations);
}

inline double kinetic_energy_of(const Particles& fluid) {
  double sum = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i)
    sum += 0.5 * fluid.mass[i] * dot(fluid.velocity[i], fluid.velocity[i]);
  return sum;
}

}  // namespace sabo::test
