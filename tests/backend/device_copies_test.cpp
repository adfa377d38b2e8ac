#include <algorithm>
#include <memory>
#include <vector>

#include "collapse.hpp"
#include "support/backends.hpp"
#include <gtest/gtest.h>

#include "base/background.hpp"

// What the host sees of a flow whose arrays are elsewhere.

namespace sabo {
namespace {

using test::collapsing;
using test::fill;

class DeviceCopies : public test::OnBackend {
 protected:
  std::unique_ptr<Backend> make() { return test::make_backend(GetParam(), collapsing()); }
};

INSTANTIATE_TEST_SUITE_P(On, DeviceCopies, testing::Values(test::On::device, test::On::cuda),
                         test::name_of_backend);

// The numbers are fetched once for a list, the places whenever they have changed.
TEST_P(DeviceCopies, TellsPlacesWithoutTheRest) {
  const auto backend = make();
  fill(*backend);
  for (std::size_t i = 0; i < backend->fluid().size(); ++i)
    backend->fluid().mass[i] *= 1 + 1e-3 * static_cast<double>(backend->fluid().id[i]);
  const auto stepper = test::stepper_of(Method::fast, *backend);
  for (int k = 0; k < 60; ++k) {
    stepper->step(2e-3);
    const Places now = backend->places();
    const std::vector<Vec3d> position(now.position.begin(), now.position.end());
    const std::vector<std::uint32_t> id(now.id.begin(), now.id.end());
    const std::vector<double> mass(now.mass.begin(), now.mass.end());
    EXPECT_TRUE(std::ranges::equal(position, backend->positions()));
    backend->fix_step(1e-3);
    EXPECT_EQ(backend->fastest(), backend->chosen_step().flow.speed);
    const Particles fluid = backend->fluid();
    EXPECT_EQ(position, fluid.position);
    EXPECT_EQ(id, fluid.id);
    EXPECT_EQ(mass, fluid.mass);
  }
  EXPECT_GT(backend->pass_times()["sort"].calls, 3u);
}

// Where a copy is still on its way while the flow goes on, it is of what was before.
TEST_P(DeviceCopies, KeepsWhatTheFluidWas) {
  const auto backend = make(), seen = make();
  for (Backend* each : {backend.get(), seen.get()}) fill(*each);
  const auto stepper = test::stepper_of(Method::fast, *backend);
  const auto seen_stepper = test::stepper_of(Method::fast, *seen);
  const auto step = [&] {
    stepper->step(2e-3);
    seen_stepper->step(2e-3);
    return seen->fluid();
  };
  for (int k = 0; k < 30; ++k) {
    const Particles expected = step();
    const KeptFluid copy = backend->keep_fluid(), same = backend->keep_fluid();
    const Particles next_expected = step();
    const KeptFluid next = backend->keep_fluid();  // before anybody has asked for the first
    const Particles last_expected = step();
    EXPECT_EQ(next.get().position, next_expected.position);
    EXPECT_EQ(copy.get().position, expected.position);
    EXPECT_EQ(copy.get().velocity, expected.velocity);
    EXPECT_EQ(copy.get().pressure, expected.pressure);
    EXPECT_EQ(&copy.get(), &same.get());
    if (k % 3 == 0) {
      EXPECT_EQ(backend->fluid().position, last_expected.position);
    }
    EXPECT_EQ(backend->keep_fluid().get().position, last_expected.position);
  }
  EXPECT_GT(backend->pass_times()["sort"].calls, 3u);
}

// While the flow goes on, which asks for other things.
TEST_P(DeviceCopies, ThreadsMayAskForWhatTheFluidWas) {
  const auto backend = make();
  fill(*backend);
  const auto stepper = test::stepper_of(Method::fast, *backend);
  Background asking;
  std::vector<std::size_t> found(20);
  for (std::size_t& count : found) {
    stepper->step(2e-3);
    asking.start([&count, copy = backend->keep_fluid()] { count = copy.get().size(); });
    const KeptFluid same = backend->keep_fluid();
    stepper->step(2e-3);
    EXPECT_EQ(backend->places().id.size(), same.get().size());
  }
  asking.settle();
  for (const std::size_t count : found) EXPECT_EQ(count, 216u);
}

// Walls beside driven particles get their density last.
TEST_P(DeviceCopies, TellsOfAWallWhatTheLastSweepMadeOfIt) {
  const auto asked = make(), unasked = make();
  for (Backend* backend : {asked.get(), unasked.get()}) {
    fill(*backend);
    for (std::size_t i = 0; i < backend->fluid().size(); ++i)
      backend->fluid().driven[i] = backend->fluid().position[i].x < 0.2 ? 1 : 0;
    backend->find_neighbours();
    backend->fix_step(1e-3);
    backend->predict();
    backend->pressure();
    backend->strain_and_density_rates();
    backend->stress();
    if (backend == asked.get()) {
      EXPECT_GT(backend->boundary().size(), 0u);
    }
    backend->momentum();
  }
  EXPECT_EQ(asked->boundary().density, unasked->boundary().density);
}

}  // namespace
}  // namespace sabo
