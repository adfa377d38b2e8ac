#include <cmath>
#include <random>

#include "support/scenes.hpp"
#include "verify/shear_flow.hpp"
#include <gtest/gtest.h>

#include "math/angle.hpp"

// A layer of Mohr-Coulomb material that shears down an incline for many depths of travel, from
// places that are no lattice. Rows that slide over each other fall into disorder, which takes more
// room: the layer swells and its speed grows with it, unless particles are shifted.

namespace sabo {
namespace {

constexpr double depth = 0.1, density = 1600;

struct Outcome {
  double depth;  ///< twice the height of the middle of mass, over the exact depth
  double speed;  ///< mean, over the exact one
};

Outcome sheared(double shifting, double time) {
  constexpr double slope = 30 * degree;
  test::Layer layer;
  FlowModel& model = layer.model;
  layer.cells = 20;
  layer.period = 20;
  model.dimension = 2;
  model.spacing = depth / layer.cells;
  model.h = 1.5 * model.spacing;
  model.state = {density, 10 * std::sqrt(g * depth)};
  model.gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
  model.diffusion_form = DiffusionForm::fourtakas;
  model.rheology = Cross{5, 1000, 1};
  model.yield = {0, 20, 0};
  model.particle_shifting = shifting;
  model.threads = 1;
  const ShearFlow steady(
      model.rheology, depth, [&](double z) { return density * model.gravity.x * (depth - z); },
      [&](double z) {
        const double p = -density * model.gravity.z * (depth - z);
        return Shear{0, model.yield(p, model.yield.slope()), p};
      });
  const auto backend = layer.make();
  test::make_hydrostatic(*backend, depth);
  Particles& fluid = backend->fluid();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> away(-0.25 * model.spacing, 0.25 * model.spacing);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    fluid.position[i] += {away(random), 0, away(random)};
    fluid.velocity[i].x = steady(fluid.position[i].z);
  }
  test::stepper_of(Method::fast, *backend)->advance_to(time);
  Outcome outcome{0, 0};
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    outcome.depth += 2 * fluid.position[i].z / depth / static_cast<double>(fluid.size());
    outcome.speed += fluid.velocity[i].x / steady.mean() / static_cast<double>(fluid.size());
  }
  return outcome;
}

TEST(ShearLayer, KeepsItsDepthAndSpeedWhereParticlesAreShifted) {
  const Outcome shifted = sheared(40, 1.3);
  EXPECT_NEAR(shifted.depth, 1, 0.01);
  EXPECT_NEAR(shifted.speed, 1, 0.02);
  const Outcome left = sheared(0, 1.3);
  EXPECT_GT(left.depth, 1.03);
  EXPECT_GT(left.speed, 1.05);
}

}  // namespace
}  // namespace sabo
