#include <cmath>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

// Flows between plates and down planes against closed forms, at coarse resolution. The wall is the
// plane half a spacing above the first boundary layer, where `mirror` puts the velocity to zero.

namespace sabo {
namespace {

using test::Layer;
using test::velocity_error;

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

void run_until(Backend& backend, Method method, double time) {
  const auto stepper = test::stepper_of(method, backend);
  // The fast method takes steps of half a viscous time where the speed of sound allows them.
  while (stepper->time() < time) stepper->step(std::min(time / 100, time - stepper->time()));
}

// Morris, Fox & Zhu 1997: L = 1e-3 m, nu = 1e-6 m2/s, F = 1e-4 m/s2, V0 = 1.25e-5 m/s.
Layer morris_channel(int cells) {
  Layer layer = two_dimensional(cells, 1e-3);
  layer.has_lid = true;
  layer.model.state = {1000, 10 * 1.25e-5};
  layer.model.rheology = Newtonian{1e-3};
  layer.model.gravity = {};
  return layer;
}

constexpr double length = 1e-3, nu = 1e-6, body_force = 1e-4, lid_speed = 1.25e-5;

/// Series solution of plane Poiseuille flow from rest (Morris et al. 1997, Eq. 23).
double poiseuille(double z, double t) {
  double u = body_force / (2 * nu) * z * (length - z);
  for (int n = 0; n < 50; ++n) {
    const double k = M_PI * (2 * n + 1) / length;
    u -= 4 * body_force * length * length / (nu * std::pow(M_PI * (2 * n + 1), 3)) *
         std::sin(k * z) * std::exp(-k * k * nu * t);
  }
  return u;
}

/// Series solution of plane Couette flow from rest, the lid moving (Morris et al. 1997, Eq. 22).
double couette(double z, double t) {
  double u = lid_speed * z / length;
  for (int n = 1; n < 100; ++n) {
    const double k = M_PI * n / length;
    u +=
        2 * lid_speed / (n * M_PI) * (n % 2 ? -1 : 1) * std::sin(k * z) * std::exp(-k * k * nu * t);
  }
  return u;
}

class SlitFlow : public testing::TestWithParam<Method> {
 protected:
  const Method method = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Both, SlitFlow, testing::ValuesIn(test::both_methods),
                         [](const auto& method) { return std::string(word_of(method.param)); });

TEST_P(SlitFlow, PoiseuilleFollowsItsSeries) {
  for (const double time : {0.0225, 0.1125, 1.0}) {
    Layer layer = morris_channel(16);
    layer.model.gravity = {body_force, 0, 0};
    auto backend = layer.make();
    run_until(*backend, method, time);
    EXPECT_LT(velocity_error(*backend, [&](double z) { return poiseuille(z, time); }), 0.02)
        << "t = " << time;
  }
}

TEST_P(SlitFlow, CouetteFollowsItsSeries) {
  for (const double time : {0.0225, 0.1125, 1.0}) {
    Layer layer = morris_channel(16);
    layer.model.walls_move = true;
    auto backend = layer.make();
    for (std::size_t i = 0; i < backend->boundary().size(); ++i)
      if (backend->boundary().position[i].z > length) backend->boundary().velocity[i].x = lid_speed;
    run_until(*backend, method, time);
    EXPECT_LT(velocity_error(*backend, [&](double z) { return couette(z, time); }), 0.05)
        << "t = " << time;
  }
}

TEST_P(SlitFlow, TwiceTheViscosityIsRejected) {
  Layer layer = morris_channel(16);
  layer.model.gravity = {body_force, 0, 0};
  layer.model.rheology = Newtonian{2e-3};
  auto backend = layer.make();
  run_until(*backend, method, 0.1125);
  EXPECT_GT(velocity_error(*backend, [](double z) { return poiseuille(z, 0.1125); }), 0.2);
}

// Bingham parameters in a slit of height 1 m driven by 1 m/s2: rho 1000, mu_B 100, tau_y 125. The
// plug is |y| < 0.125 m and moves at 0.703125 m/s; Cross with mu_0/mu_inf 1e3: 0.704844 m/s.
double slit_speed(Method method, Rheology law, double yield, double& gradient_in_plug,
                  double time = 3, int cells = 16) {
  Layer layer = two_dimensional(cells, 1.0);
  layer.has_lid = true;
  layer.model.state = {1000, 10};
  layer.model.gravity = {1, 0, 0};
  layer.model.rheology = law;
  layer.model.yield = {yield, 0, 0};
  auto backend = layer.make();
  run_until(*backend, method, time);  // 3 s: five relaxation times of the Bingham fluid
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

TEST_P(SlitFlow, BinghamParametersGiveThePlugSpeed) {
  double gradient = 0;
  EXPECT_NEAR(slit_speed(method, Cross{100, 1000, 1}, 125, gradient), 0.704844, 0.05 * 0.704844);
  EXPECT_LT(gradient, 0.05);  // a Newtonian fluid of mu_B would have 0.5 there
  EXPECT_NEAR(slit_speed(method, Bingham{{100, 1000}}, 125, gradient), 0.703125, 0.05 * 0.703125);
  EXPECT_LT(gradient, 0.05);
}

// k = 300 Pa s^n, n = 1/2, the same plug of half width y0 = 0.125 m in the half gap of 0.5 m:
// u = n/(n+1) (rho a/k)^(1/n) (0.5 - y0)^(1/n + 1) = 1/3 (10/3)^2 0.375^3 = 0.195313 m/s.
TEST_P(SlitFlow, HerschelBulkleyReachesItsPlugSpeed) {
  double gradient = 0;
  const HerschelBulkley law{300, 0.5, 100, 3e4};
  EXPECT_NEAR(slit_speed(method, law, 125, gradient, 4, 20), 0.195313, 0.05 * 0.195313);
  EXPECT_LT(gradient, 0.02);
}

}  // namespace
}  // namespace sabo
