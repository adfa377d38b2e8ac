#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "analysis/columns.hpp"
#include "analysis/convergence.hpp"
#include "analysis/tracks.hpp"
#include "analysis/volume_ledger.hpp"
#include "terrain/jitter.hpp"

// Backends differ in the last digits, and a flow of particles amplifies them: fronts and maps of
// single runs scatter. What must agree are means over jittered starts, and what no step may change.

namespace sabo {
namespace {

constexpr double spacing = 0.1;
constexpr int starts = 8;
constexpr double line = 0.7;  // x, m

FlowModel slumping() {
  FlowModel model = test::plain_model(spacing, 30, 5);
  model.rheology = Cross{5, 100, 1};
  model.yield = {20, 15, 0};
  return model;
}

struct Slump {
  double front = 0;           ///< mean distance of the farthest tenth from the middle, m
  double mass = 0;            ///< kg
  double beyond = 0;          ///< volume that has crossed a line beside the block, m3
  std::vector<double> depth;  ///< map, m
};

/// By what the backend shows of its particles after each step.
double volume_beyond(double time, Stepper& stepper, Backend& backend) {
  Tracks tracks;
  VolumeLedger ledger(1000, {{{line, -5, 0}, {line, 5, 0}}}, {0.3, 0.3, 0});
  ledger.release(backend.fluid());
  tracks.advance(backend.places());
  while (stepper.time() < time) {
    stepper.step(time - stepper.time());
    const Places now = backend.places();
    ledger.record(tracks.advance(now), now);
  }
  return ledger.row().beyond;
}

Slump slump(test::On on, Method method, std::uint64_t seed) {
  const auto backend = test::make_backend(on, slumping());
  const Surface level{Raster(Grid{2, 2, -20, 20, 20, 20})};
  test::add_block(backend->boundary(), backend->model(), {-12, 18, -12, 18, -3, 0});
  test::add_block(backend->fluid(), backend->model(), {0, 6, 0, 6, 0, 6});
  jitter(backend->fluid(), level, {0.05 * spacing, 0.25 * spacing, seed});
  const auto stepper = test::stepper_of(method, *backend);
  const double beyond = volume_beyond(0.6, *stepper, *backend);

  const Particles& fluid = backend->fluid();
  std::vector<double> distance;
  double there = 0;  // kg
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d& x = fluid.position[i];
    distance.push_back(std::hypot(x.x - 0.3, x.y - 0.3));
    if (x.x > line) there += fluid.mass[i];
  }
  EXPECT_NEAR(beyond, there / 1000, 1e-12);
  std::ranges::sort(distance);
  const auto first = distance.end() - static_cast<std::ptrdiff_t>(distance.size() / 10);
  Columns columns(Raster(Grid{14, 14, -1.1, 1.7, 0.2, 0.2}, 0.0), spacing, 1000);
  columns.update(fluid);
  return {std::accumulate(first, distance.end(), 0.0) / static_cast<double>(distance.end() - first),
          std::accumulate(fluid.mass.begin(), fluid.mass.end(), 0.0), beyond,
          columns.depth().values};
}

/// Of what was found from all starts.
template <class Value>
Scatter scatter_over(const std::vector<Slump>& slumps, const Value& value) {
  std::vector<double> values;
  for (const Slump& slump : slumps) values.push_back(value(slump));
  return scatter_of(values);
}

/// By how many of its standard errors two means differ.
double distance_of_means(const Scatter& a, const Scatter& b) {
  return (a.mean - b.mean) / (std::hypot(a.deviation, b.deviation) / std::sqrt(double(starts)));
}

/// The same over the cells of a map that are wet on average, in the root mean square.
double distance_of_maps(const std::vector<Slump>& here, const std::vector<Slump>& there) {
  double sum = 0;
  int wet = 0;
  for (std::size_t cell = 0; cell < here[0].depth.size(); ++cell) {
    const auto depth = [cell](const Slump& slump) { return slump.depth[cell]; };
    const Scatter a = scatter_over(here, depth), b = scatter_over(there, depth);
    if (b.mean < wet_depth(spacing)) continue;
    sum += std::pow(distance_of_means(a, b), 2);
    ++wet;
  }
  EXPECT_GT(wet, 20);
  return std::sqrt(sum / wet);
}

class Ensemble : public test::OnBackend {};

INSTANTIATE_TEST_SUITE_P(On, Ensemble, testing::Values(test::On::device, test::On::cuda),
                         test::name_of_backend);

TEST_P(Ensemble, HasTheFrontTheMapAndTheLedgersOfTheProcessor) {
  for (const Method method : test::both_methods) {
    std::vector<Slump> here, there;
    for (std::uint64_t seed = 1; seed <= starts; ++seed) {
      const Slump a = slump(GetParam(), method, seed), b = slump(test::On::cpu, method, seed);
      EXPECT_NEAR(a.mass, b.mass, 1e-12 * b.mass);  // in another order
      EXPECT_GT(a.front, 0.6);                      // from 0.39 m
      here.push_back(a);
      there.push_back(b);
    }
    const auto front = [](const Slump& slump) { return slump.front; };
    const Scatter a = scatter_over(here, front), b = scatter_over(there, front);
    EXPECT_GT(a.deviation, 0);
    EXPECT_LE(std::abs(distance_of_means(a, b)), 2) << word_of(method);
    EXPECT_LE(distance_of_maps(here, there), 2) << word_of(method);
    const auto beyond = [](const Slump& slump) { return slump.beyond; };
    const Scatter c = scatter_over(here, beyond), d = scatter_over(there, beyond);
    EXPECT_GT(d.mean, 0.02);  // m3, of 0.22
    EXPECT_LE(std::abs(distance_of_means(c, d)), 2) << word_of(method);
  }
}

}  // namespace
}  // namespace sabo
