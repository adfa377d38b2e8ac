#include <array>
#include <cmath>
#include <random>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "math/angle.hpp"

// The sums of the paper written out once more, with full 3 x 3 tensors and nothing shared with the
// program but the numbers of the model: Eqs. 4, 7, 10, 11, 13, 14, 16-18, 22-25.

namespace sabo {
namespace {

using Tensor = std::array<std::array<double, 3>, 3>;
using Vector = std::array<double, 3>;

constexpr double h = 0.15, rho0 = 1500, c0 = 20, zeta = 0.1;
constexpr double mu_inf = 2, mu_0 = 200, cohesion = 10, phi = 25, r_u = 0.3;

struct Point {
  Vector x, v;
  double rho, m;
  bool is_fluid;
  // results
  double rate = 0, p = 0, mu = 0;
  Tensor tau{};
  Vector a{};
};

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// grad_i W_ij from W = a (1 - q/2)^4 (2q + 1) by the product rule.
Vector kernel_gradient(const Vector& x) {
  const double r = std::sqrt(product(x, x)), q = r / h;
  if (q >= 2) return {0, 0, 0};
  const double alpha = 21 / (16 * M_PI * h * h * h), t = 1 - q / 2;
  const double slope = alpha * (-2 * t * t * t * (2 * q + 1) + 2 * t * t * t * t) / h;
  return {slope * x[0] / r, slope * x[1] / r, slope * x[2] / r};
}

void add_density_rate_and_stress(std::vector<Point>& points, Point& i) {
  Tensor gradient{};  // of velocity: d v_a / d x_b
  for (const Point& j : points) {
    if (&j == &i || (!i.is_fluid && !j.is_fluid)) continue;
    const Vector x = minus(i.x, j.x), v = minus(i.v, j.v), dw = kernel_gradient(x);
    i.rate += j.m * product(v, dw);
    if (i.is_fluid && j.is_fluid) {
      const double psi = 2 * (i.rho / j.rho - 1) / (product(x, x) + 0.01 * h * h);
      i.rate += zeta * h * c0 * j.m * psi * product(x, dw);
    }
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) gradient[a][b] -= j.m / j.rho * v[a] * dw[b];
  }
  Tensor eps{};
  double contraction = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      eps[a][b] = gradient[a][b] + gradient[b][a];
      contraction += eps[a][b] * eps[a][b];
    }
  const double gd = std::sqrt(contraction / 2);
  i.p = c0 * c0 * rho0 / 7 * (std::pow(i.rho / rho0, 7) - 1);
  const double tau_b = cohesion + (1 - r_u) * std::max(i.p, 0.0) * std::tan(phi * degree);
  const double k = mu_0 / tau_b;
  i.mu = (mu_0 + k * gd * mu_inf) / (1 + k * gd);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) i.tau[a][b] = i.mu * eps[a][b];
}

void add_acceleration(const std::vector<Point>& points, Point& i) {
  i.a = {0, 0, -9.81};
  for (const Point& j : points) {
    if (&j == &i) continue;
    const Vector dw = kernel_gradient(minus(i.x, j.x));
    for (int a = 0; a < 3; ++a) {
      i.a[a] -= j.m * (i.p / (i.rho * i.rho) + j.p / (j.rho * j.rho)) * dw[a];
      for (int b = 0; b < 3; ++b)
        i.a[a] += j.m * (i.tau[a][b] / (i.rho * i.rho) + j.tau[a][b] / (j.rho * j.rho)) * dw[b];
    }
  }
}

std::vector<Point> random_cloud() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Point> points(60);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{0.5 * u(random), 0.5 * u(random), 0.5 * u(random)},
                 {u(random) - 0.5, u(random) - 0.5, u(random) - 0.5},
                 rho0 * (0.98 + 0.04 * u(random)),
                 1.5 * (0.9 + 0.2 * u(random)),
                 k < 40};
  return points;
}

void load(Backend& backend, const std::vector<Point>& points) {
  for (const Point& p : points) {
    Particles& set = p.is_fluid ? backend.fluid() : backend.boundary();
    test::add_particle(set, backend.model(), {p.x[0], p.x[1], p.x[2]}, {p.v[0], p.v[1], p.v[2]});
    set.density.back() = p.rho;
    set.mass.back() = p.m;
  }
}

TEST(ReferenceBackend, MatchesTheSumsOfThePaperWrittenOut) {
  FlowModel model;
  model.spacing = 0.1;
  model.h = h;
  model.state = {rho0, c0};
  model.rheology = Cross{mu_inf, mu_0 / mu_inf, 1};
  model.yield = {cohesion, phi, r_u};
  auto backend = make_backend(BackendKind::reference, model);
  std::vector<Point> points = random_cloud();
  load(*backend, points);
  backend->find_neighbours();
  backend->pressure();
  backend->strain_and_density_rates();
  backend->stress();
  backend->momentum();

  for (Point& p : points) add_density_rate_and_stress(points, p);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(backend->density_rates()[k], points[k].rate, 1e-9 * (1 + std::abs(points[k].rate)));
    if (!points[k].is_fluid) continue;
    add_acceleration(points, points[k]);
    const Vec3d& a = backend->accelerations()[k];
    const double scale = 1e-10 * std::sqrt(product(points[k].a, points[k].a));
    EXPECT_NEAR(a.x, points[k].a[0], scale);
    EXPECT_NEAR(a.y, points[k].a[1], scale);
    EXPECT_NEAR(a.z, points[k].a[2], scale);
    EXPECT_NEAR(backend->fluid().viscosity[k], points[k].mu, 1e-10 * points[k].mu);
  }
}

}  // namespace
}  // namespace sabo
