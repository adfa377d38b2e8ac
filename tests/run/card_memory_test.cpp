#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/memory_estimate.hpp"
#include "run/preview_card.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

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

TEST(CardMemory, ThatDoesNotSufficeIsToldOf) {
  const GraphicsCard card{"Card X", 8e9, 6e9};
  const auto told = [&card](double needed) {
    Preview preview;
    tell_card_memory(preview, needed, card);
    return preview.text();
  };
  EXPECT_THAT(told(5.9e9), HasSubstr("about 5900 MB of the graphics card, of 6000 MB that are free "
                                     "on Card X"));
  EXPECT_THAT(told(5.9e9), Not(HasSubstr("fit")));
  EXPECT_THAT(told(6.1e9), HasSubstr("the run will not fit into the memory of the graphics card; "
                                     "raise numerics.spacing, or use --backend cpu"));
}

TEST(CardMemory, IsToldOfWhereThereIsNoCard) {
  Preview preview;
  tell_missing_card(preview, 7e8, "no card");
  EXPECT_THAT(preview.text(), HasSubstr("about 700 MB of the graphics card"));
  EXPECT_THAT(preview.text(), HasSubstr("numerics.backend: no card; use --backend cpu"));
}

}  // namespace
}  // namespace sabo
