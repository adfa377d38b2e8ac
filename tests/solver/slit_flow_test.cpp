#include <cmath>

#include "support/scenes.hpp"
#include "verify/profile.hpp"
#include "verify/startup_solution.hpp"
#include <gtest/gtest.h>

// Flows between plates by the explicit method, at coarse resolution. The wall is the plane half a
// spacing above the first boundary layer, where `mirror` puts the velocity to zero. Those of the
// fast method are cases of verification.

namespace sabo {
namespace {

using test::Layer;

Layer two_dimensional(int cells, double depth) {
  Layer layer;
  layer.model.dimension = 2;
  layer.cells = cells;
  layer.model.spacing = depth / cells;
  layer.model.h = 1.5 * layer.model.spacing;
  layer.model.viscous_operator = ViscousOperator::morris;
  layer.model.boundary_stress = BoundaryStress::mirror;
  layer.model.threads = 1;
  return layer;
}

void run_until(Backend& backend, double time) {
  test::stepper_of(Method::paper, backend)->advance_to(time);
}

constexpr StartUp exact;

Layer morris_channel(int cells) {
  Layer layer = two_dimensional(cells, exact.length);
  layer.has_lid = true;
  layer.model.state = {1000, 10 * exact.lid_speed};
  layer.model.rheology = Newtonian{1000 * exact.viscosity};
  layer.model.gravity = {};
  return layer;
}

TEST(PaperSlitFlow, PoiseuilleFollowsItsSeries) {
  for (const double time : {0.0225, 0.1125, 1.0}) {
    Layer layer = morris_channel(16);
    layer.model.gravity = {exact.body_force, 0, 0};
    auto backend = layer.make();
    run_until(*backend, time);
    EXPECT_LT(profile_error(backend->fluid(), [&](double z) { return exact.poiseuille(z, time); }),
              0.02)
        << "t = " << time;
  }
}

TEST(PaperSlitFlow, CouetteFollowsItsSeries) {
  for (const double time : {0.0225, 0.1125, 1.0}) {
    Layer layer = morris_channel(16);
    layer.model.walls_move = true;
    auto backend = layer.make();
    for (std::size_t i = 0; i < backend->boundary().size(); ++i)
      if (backend->boundary().position[i].z > exact.length)
        backend->boundary().velocity[i].x = exact.lid_speed;
    run_until(*backend, time);
    EXPECT_LT(profile_error(backend->fluid(), [&](double z) { return exact.couette(z, time); }),
              0.05)
        << "t = " << time;
  }
}

// Bingham parameters in a slit of height 1 m driven by 1 m/s2: rho 1000, mu_B 100, tau_y 125. The
// plug is |y| < 0.125 m and moves at 0.703125 m/s; Cross with mu_0/mu_inf 1e3: 0.704844 m/s.
double slit_speed(Rheology law, double yield, double& gradient_in_plug, double time = 3,
                  int cells = 16) {
  Layer layer = two_dimensional(cells, 1.0);
  layer.has_lid = true;
  layer.model.state = {1000, 10};
  layer.model.gravity = {1, 0, 0};
  layer.model.rheology = law;
  layer.model.yield = {yield, 0, 0};
  auto backend = layer.make();
  run_until(*backend, time);  // 3 s: five relaxation times of the Bingham fluid
  double fastest = 0, slowest_in_plug = 1e9;
  const Particles& fluid = backend->fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    fastest = std::max(fastest, fluid.velocity[i].x);
    if (std::abs(fluid.position[i].z - 0.5) < 0.1)
      slowest_in_plug = std::min(slowest_in_plug, fluid.velocity[i].x);
  }
  gradient_in_plug = (fastest - slowest_in_plug) / 0.1;
  return fastest;
}

TEST(PaperSlitFlow, BinghamParametersGiveThePlugSpeed) {
  double gradient = 0;
  EXPECT_NEAR(slit_speed(Cross{100, 1000, 1}, 125, gradient), 0.704844, 0.05 * 0.704844);
  EXPECT_LT(gradient, 0.05);  // a Newtonian fluid of mu_B would have 0.5 there
  EXPECT_NEAR(slit_speed(Bingham{{100, 1000}}, 125, gradient), 0.703125, 0.05 * 0.703125);
  EXPECT_LT(gradient, 0.05);
}

// k = 300 Pa s^n, n = 1/2, the same plug of half width y0 = 0.125 m in the half gap of 0.5 m:
// u = n/(n+1) (rho a/k)^(1/n) (0.5 - y0)^(1/n + 1) = 1/3 (10/3)^2 0.375^3 = 0.195313 m/s.
TEST(PaperSlitFlow, HerschelBulkleyReachesItsPlugSpeed) {
  double gradient = 0;
  const HerschelBulkley law{300, 0.5, 100, 3e4};
  EXPECT_NEAR(slit_speed(law, 125, gradient, 4, 20), 0.195313, 0.05 * 0.195313);
  EXPECT_LT(gradient, 0.02);
}

}  // namespace
}  // namespace sabo
