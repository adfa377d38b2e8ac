#include <algorithm>
#include <string>
#include <vector>

#include "support/archives.hpp"
#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

// A flow goes on with the same bits from an archived state, on every backend.

namespace sabo {
namespace {

using Archived = test::OnBackend;

INSTANTIATE_TEST_SUITE_P(On, Archived, testing::ValuesIn(test::all_backends),
                         test::name_of_backend);

FlowModel sleepy_mud() {
  FlowModel model = test::plain_model(0.1, 30, 5);
  model.rheology = Cross{5, 1000, 1};
  model.yield = {1500, 0, 0};
  model.diffusion_form = DiffusionForm::fourtakas;
  model.artificial_viscosity = 0.02;
  model.particle_shifting = 0.1;
  model.sleep = {0.2, 0.02};
  return model;
}

/// A block that collapses on a floor, a part of which is a body; one edge of it may be driven.
std::unique_ptr<Backend> block(test::On on, bool is_driven) {
  auto made = test::make_backend(on, sleepy_mud());
  Backend& backend = *made;
  test::add_block(backend.fluid(), backend.model(), {0, 6, 0, 6, 0, 6});
  test::add_block(backend.boundary(), backend.model(), {-6, 12, -6, 12, -3, 0});
  Particles& fluid = backend.fluid();
  Particles& boundary = backend.boundary();
  for (std::size_t b = 0; b < boundary.size(); ++b)
    boundary.body[b] = boundary.position[b].x > 0.4 ? 1 : 0;
  for (std::size_t i = 0; is_driven && i < fluid.size(); ++i) {
    if (fluid.position[i].x > 0.1) continue;
    fluid.driven[i] = 1;
    fluid.velocity[i] = {0.5, 0, 0};
  }
  return made;
}

struct Flowing {
  Flowing(test::On on, Method method, bool is_driven)
      : backend(block(on, is_driven)), stepper(test::stepper_of(method, *backend)) {}

  void go(int steps) {
    for (int k = 0; k < steps; ++k) stepper->step(2e-3);
  }
  /// Without what it took in time.
  std::string state() {
    backend->pass_times().clear();
    return test::archived(*stepper) + test::archived(*backend);
  }

  std::unique_ptr<Backend> backend;
  std::unique_ptr<Stepper> stepper;
};

TEST_P(Archived, FlowsGoOnWithTheSameBits) {
  for (const Method method : test::both_methods)
    for (const bool is_driven : {false, true}) {
      Flowing whole(GetParam(), method, is_driven);
      whole.go(60);
      const std::string stepper = test::archived(*whole.stepper);
      const std::string backend = test::archived(*whole.backend);
      whole.go(60);

      Flowing resumed(GetParam(), method, is_driven);
      test::restore(*resumed.stepper, stepper);
      test::restore(*resumed.backend, backend);
      resumed.go(60);
      EXPECT_TRUE(resumed.state() == whole.state()) << word_of(method) << is_driven;
      if (method == Method::fast && !is_driven) {
        EXPECT_GT(whole.backend->asleep_count(), 0u);
      }
      EXPECT_GT(norm(whole.backend->body_loads().at(0).force), 0);
    }
}

TEST_P(Archived, StatesThatCannotBeAreRefused) {
  Flowing whole(GetParam(), Method::fast, false);
  whole.go(2);
  whole.backend->fluid().position[3].x = 1e300;
  const std::string backend = test::archived(*whole.backend);
  Flowing resumed(GetParam(), Method::fast, false);
  EXPECT_THROW(test::restore(*resumed.backend, backend), RunError);
}

}  // namespace
}  // namespace sabo
