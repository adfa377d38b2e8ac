#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "run/memory_estimate.hpp"

namespace sabo {
namespace {

// What the code of graphics cards allocates for a layer 20 particles deep.
TEST(CardMemory, IsForecastAsItIsAllocated) {
  for (const Method method : test::both_methods) {
    test::Layer layer;
    layer.model = test::plain_model(0.1, 30, 1);
    layer.model.diffusion_form = DiffusionForm::fourtakas;
    layer.cells = 20;
    layer.period = 24;
    const auto backend = test::make_backend(test::On::device, layer.periodic_model());
    layer.fill(*backend);
    test::make_hydrostatic(*backend, 2);
    test::stepper_of(method, *backend)->step();
    const auto fluid = static_cast<double>(backend->fluid().size());
    const auto floor = static_cast<double>(backend->boundary().size());
    const double forecast = card_memory(layer.model, method, fluid, floor);
    EXPECT_NEAR(static_cast<double>(backend->device_bytes()) / forecast, 1, 0.1);
    EXPECT_LT(static_cast<double>(backend->device_bytes()) / (fluid + floor), 1300);
  }
}

}  // namespace
}  // namespace sabo
