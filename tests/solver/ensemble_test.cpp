#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "analysis/convergence.hpp"
#include "terrain/jitter.hpp"

// Backends differ in the last digits, and a flow of particles amplifies them: fronts of single runs
// scatter. What must agree are means over jittered starts, and what no step may change.

namespace sabo {
namespace {

constexpr double spacing = 0.1;
constexpr int starts = 8;

FlowModel slumping() {
  FlowModel model = test::plain_model(spacing, 30, 5);
  model.rheology = Cross{5, 100, 1};
  model.yield = {20, 15, 0};
  return model;
}

struct Slump {
  double front = 0;  ///< mean distance of the farthest tenth from the middle, m
  double mass = 0;   ///< kg
};

Slump slump(test::On on, Method method, std::uint64_t seed) {
  const auto backend = test::make_backend(on, slumping());
  const Surface level{Raster(Grid{2, 2, -20, 20, 20, 20})};
  test::add_block(backend->boundary(), backend->model(), {-12, 18, -12, 18, -3, 0});
  test::add_block(backend->fluid(), backend->model(), {0, 6, 0, 6, 0, 6});
  jitter(backend->fluid(), level, {0.05 * spacing, 0.25 * spacing, seed});
  const auto stepper = test::stepper_of(method, *backend);
  stepper->advance_to(0.6);

  const Particles& fluid = backend->fluid();
  std::vector<double> distance;
  for (const Vec3d& x : fluid.position) distance.push_back(std::hypot(x.x - 0.3, x.y - 0.3));
  std::ranges::sort(distance);
  const auto first = distance.end() - static_cast<std::ptrdiff_t>(distance.size() / 10);
  return {std::accumulate(first, distance.end(), 0.0) / static_cast<double>(distance.end() - first),
          std::accumulate(fluid.mass.begin(), fluid.mass.end(), 0.0)};
}

class Ensemble : public test::OnBackend {};

INSTANTIATE_TEST_SUITE_P(On, Ensemble, testing::Values(test::On::device, test::On::cuda),
                         test::name_of_backend);

TEST_P(Ensemble, HasTheFrontOfTheProcessorAndAllOfItsMass) {
  for (const Method method : test::both_methods) {
    std::vector<double> here, there;
    for (std::uint64_t seed = 1; seed <= starts; ++seed) {
      const Slump a = slump(GetParam(), method, seed), b = slump(test::On::cpu, method, seed);
      here.push_back(a.front);
      there.push_back(b.front);
      EXPECT_NEAR(a.mass, b.mass, 1e-12 * b.mass);  // in another order
      EXPECT_GT(a.front, 0.6);                      // from 0.39 m
    }
    const Scatter a = scatter_of(here), b = scatter_of(there);
    EXPECT_GT(a.deviation, 0);
    const double error = std::hypot(a.deviation, b.deviation) / std::sqrt(double(starts));
    EXPECT_NEAR(a.mean, b.mean, 2 * error) << word_of(method);
  }
}

}  // namespace
}  // namespace sabo
