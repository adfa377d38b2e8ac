#include <cmath>
#include <random>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

// What the pressure of the fluid and of the walls takes from a motion is the power of compression,
// sum of m p / rho0^2 drho/dt: nothing is lost to the walls, here two that a periodic fluid lies
// between. Without weight, for what the weight adds to the pressure of a wall is not the fluid's.
class WallContactOf : public test::OnBackend {};

TEST_P(WallContactOf, TurnsAllWorkOfPressureIntoCompression) {
  FlowModel model = test::plain_model(0.1, 30, 1);
  model.gravity = {};
  model.density_diffusion = 0;
  model.periodic.period[0] = {0.8, 0, 0};
  model.periodic.period[1] = {0, 0.8, 0};
  const auto backend = test::make_backend(GetParam(), model);
  Particles& fluid = backend->fluid();
  test::add_block(fluid, model, {0, 8, 0, 8, 0, 5});
  test::add_block(backend->boundary(), model, {0, 8, 0, 8, -3, 0});
  test::add_block(backend->boundary(), model, {0, 8, 0, 8, 5, 8});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    fluid.position[i] += 0.02 * Vec3d{part(random), part(random), part(random)};
    // Squeezed between the walls, as a layer that thins.
    fluid.velocity[i] = {0.2 * part(random), 0.2 * part(random), 4 * (0.25 - fluid.position[i].z)};
    fluid.density[i] = 1000 * (1.002 + 0.001 * part(random));
  }
  backend->find_neighbours();
  backend->pressure();
  backend->wall_pressure();
  backend->near_forces();
  backend->wall_resistance();
  backend->near_motion();
  const Particles& after = backend->fluid();
  double work = 0, compression = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    work += after.mass[i] * dot(backend->accelerations()[i], after.velocity[i]);
    compression += after.mass[i] * after.pressure[i] / 1e6 * backend->density_rates()[i];
  }
  EXPECT_GT(std::abs(work), 10);  // W
  EXPECT_NEAR(compression, -work, 0.01 * std::abs(work));
}

INSTANTIATE_TEST_SUITE_P(Backends, WallContactOf, ::testing::ValuesIn(test::all_backends),
                         test::name_of_backend);

}  // namespace
}  // namespace sabo
