#include <cmath>

#include "support/scenes.hpp"
#include "verify/slab_solution.hpp"
#include <gtest/gtest.h>

#include "math/angle.hpp"

// A slab 3.75 m thick of a Cross fluid with internal friction starts from rest on an infinite
// slope: the fast method against the same fluid in one dimension.

namespace sabo {
namespace {

constexpr double slab_depth = 3.75;

struct Slab {
  double slope = 33 * degree;
  double ratio = 1000;  ///< mu_0 / mu_B
  int dimension = 2;
  int layers = 5;
};

double mean_speed(const Slab& slab, double time) {
  test::Layer layer;
  layer.model.dimension = slab.dimension;
  layer.cells = slab.layers;
  layer.period = slab.dimension == 2 ? 12 : 8;
  layer.model.spacing = slab_depth / slab.layers;
  layer.model.h = 1.5 * layer.model.spacing;
  layer.model.state = {1726, 10 * std::sqrt(9.81 * slab_depth)};
  layer.model.gravity = {9.81 * std::sin(slab.slope), 0, -9.81 * std::cos(slab.slope)};
  layer.model.diffusion_form = DiffusionForm::fourtakas;
  layer.model.rheology = Cross{1255, slab.ratio, 1};
  layer.model.yield = {0, 28, 0};
  layer.model.threads = 1;
  const auto backend = layer.make();
  test::make_hydrostatic(*backend, slab_depth);
  const auto stepper = test::stepper_of(Method::fast, *backend);
  stepper->advance_to(time);
  double sum = 0;
  for (const Vec3d& v : backend->fluid().velocity) sum += v.x;
  return sum / static_cast<double>(backend->fluid().size());
}

// By another program, 400 cells, dt 5e-4 s: 2.354 and 2.101 m/s at 3 s.
TEST(SlabSolution, IsConverged) {
  EXPECT_NEAR((SlabSolution{33 * degree, 28 * degree}.mean_speed(3)), 2.354, 0.005);
  SlabSolution stiffer{33 * degree, 28 * degree};
  stiffer.ratio = 1e4;
  EXPECT_NEAR(stiffer.mean_speed(3), 2.101, 0.005);
}

TEST(FastSlab, FollowsTheOneDimensionalSolution) {
  for (const double ratio : {1e3, 1e4}) {
    SlabSolution exact{33 * degree, 28 * degree};
    exact.ratio = ratio;
    const double speed = exact.mean_speed(3);
    for (const int layers : {5, 10})
      EXPECT_NEAR((mean_speed({33 * degree, ratio, 2, layers}, 3)), speed, 0.05 * speed)
          << ratio << ", " << layers << " layers";
  }
}

TEST(FastSlab, FollowsTheOneDimensionalSolutionInThreeDimensions) {
  const double speed = SlabSolution{33 * degree, 28 * degree}.mean_speed(3);
  EXPECT_NEAR((mean_speed({33 * degree, 1e3, 3, 5}, 3)), speed, 0.05 * speed);
}

TEST(FastSlab, ComesNearerWithMoreLayers) {
  const double speed = SlabSolution{33 * degree, 28 * degree}.mean_speed(3);
  const auto error = [&](int layers) {
    return std::abs(mean_speed({33 * degree, 1e3, 2, layers}, 3) - speed);
  };
  EXPECT_LT(error(10), 0.6 * error(5));
}

// 16 deg is below the friction angle of 28 deg: with r = tan 16 / tan 28 the shear rate is
// x tau_B / mu_0, x = r / (1 - r) (to mu_B / mu_0), so the mean speed is
// x rho g cos(16) tan(28) H^2 / (3 mu_0).
TEST(FastSlab, OnlyCreepsBelowTheFrictionAngle) {
  const double r = std::tan(16 * degree) / std::tan(28 * degree);
  const double creep = r / (1 - r) * 1726 * 9.81 * std::cos(16 * degree) * std::tan(28 * degree) *
                       slab_depth * slab_depth / (3 * 1255e3);
  EXPECT_NEAR(creep, 0.0378, 1e-4);
  EXPECT_NEAR((mean_speed({16 * degree, 1e3, 2, 10}, 2)), creep, 0.1 * creep);
}

}  // namespace
}  // namespace sabo
