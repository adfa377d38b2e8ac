#pragma once

#include <memory>
#include <string>
#include <utility>

#include "support/archives.hpp"
#include "support/scenes.hpp"

// A flow with something of all that there is: yield and sleep, shifting, a body, driven particles.

namespace sabo::test {

inline FlowModel sleepy_mud() {
  FlowModel model = plain_model(0.1, 30, 5);
  model.rheology = Cross{5, 1000, 1};
  model.yield = {1500, 0, 0};
  model.diffusion_form = DiffusionForm::fourtakas;
  model.artificial_viscosity = 0.02;
  model.particle_shifting = 0.1;
  model.sleep = {0.2, 0.02};
  return model;
}

/// A block that collapses on a floor, a part of which is a body; one edge of it may be driven.
struct SleepyBlock {
  /// `made` is of sleepy_mud(), and empty.
  SleepyBlock(std::unique_ptr<Backend> made, Method method, bool is_driven)
      : backend(std::move(made)) {
    Particles& fluid = backend->fluid();
    Particles& boundary = backend->boundary();
    add_block(fluid, backend->model(), {0, 6, 0, 6, 0, 6});
    add_block(boundary, backend->model(), {-6, 12, -6, 12, -3, 0});
    for (std::size_t b = 0; b < boundary.size(); ++b)
      boundary.body[b] = boundary.position[b].x > 0.4 ? 1 : 0;
    for (std::size_t i = 0; is_driven && i < fluid.size(); ++i) {
      if (fluid.position[i].x > 0.1) continue;
      fluid.driven[i] = 1;
      fluid.velocity[i] = {0.5, 0, 0};
    }
    stepper = stepper_of(method, *backend);
  }

  void go(int steps) {
    for (int k = 0; k < steps; ++k) stepper->step(2e-3);
  }
  /// Without what it took in time.
  std::string state() {
    backend->pass_times().clear();
    return archived(*stepper) + archived(*backend);
  }

  std::unique_ptr<Backend> backend;
  std::unique_ptr<Stepper> stepper;
};

}  // namespace sabo::test
