#include <array>
#include <cmath>
#include <vector>

#include "support/backends.hpp"
#include "support/clouds.hpp"
#include "support/scenes.hpp"
#include "support/viscous_step.hpp"
#include <gtest/gtest.h>

#include "physics/pair/forces.hpp"
#include "physics/pair/viscous_flux.hpp"

// The matrix of the implicit viscosity: what it is, and what that does to a flow.

namespace sabo {
namespace {

using test::advance_velocity;
using test::kinetic_energy_of;
using test::OpenedReference;
using test::prepare;
using test::set_viscosity;
using test::viscous;

/// Solves A x = b by elimination.
std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)  // positive definite: no pivoting
    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= f * a[k][j];
      b[i] -= f * b[k];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

double component(const Vec3d& v, std::size_t c) { return c == 0 ? v.x : c == 1 ? v.y : v.z; }

using Matrix = std::vector<std::vector<double>>;
/// Conductances of all pairs, kg/s.
Matrix conductances(const OpenedReference& backend, const Particles& fluid) {
  const auto kernel = backend.model().kernel<double>();
  const std::size_t n = fluid.size();
  Matrix a(n, std::vector<double>(n, 0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const double r = norm(fluid.position[i] - fluid.position[j]);
      const double mu =
          backend.model().two_point_scale() * 2 / (1 / fluid.viscosity[i] + 1 / fluid.viscosity[j]);
      a[i][j] =
          -2 * mu * fluid.mass[i] * fluid.mass[j] / (1000.0 * 1000.0) * kernel.gradient_factor(r);
    }
  return a;
}

/// K, written out from its power: v.K v = sum_i (sum_j a_ij |v_ij|^2 + D_i : D_i^T) / 2 with
/// D_i = sum_j a_ij v_ij (x) S_i x_ij.
Matrix viscous_matrix(const OpenedReference& backend, const Particles& fluid) {
  const Matrix a = conductances(backend, fluid);
  const std::size_t n = fluid.size();
  Matrix k(3 * n, std::vector<double>(3 * n, 0));
  for (std::size_t i = 0; i < n; ++i) {
    Sym3<double> moments{};
    for (std::size_t j = 0; j < n; ++j)
      moments += scaled_square(a[i][j], fluid.position[i] - fluid.position[j]);
    const Sym3<double> root = inverse_root(moments, 3);
    std::vector<Vec3d> share(n);  // D_i = sum_j v_j (x) share_j
    for (std::size_t j = 0; j < n; ++j) {
      const Vec3d ax = a[i][j] * (root * (fluid.position[i] - fluid.position[j]));
      share[i] += ax;
      share[j] -= ax;
      for (std::size_t c = 0; c < 3; ++c) {
        k[3 * i + c][3 * i + c] += a[i][j];
        k[3 * i + c][3 * j + c] -= a[i][j];
      }
    }
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n; ++q)
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t c = 0; c < 3; ++c)
            k[3 * p + r][3 * q + c] += 0.5 * component(share[p], c) * component(share[q], r);
  }
  return k;
}

/// (M + dt K + dt D) v' = M (v + dt a) + dt D w.
std::vector<double> dense_step(const OpenedReference& backend, const Particles& fluid, double dt) {
  Matrix matrix = viscous_matrix(backend, fluid);
  for (auto& row : matrix)
    for (double& entry : row) entry *= dt;
  std::vector<double> right(matrix.size());
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const WallShare& wall = backend.wall_share_[i];
    const double drag = dt * backend.wall_drag_[i];
    const Vec3d carried = wall.share > 0 ? drag / wall.share * wall.velocity : Vec3d{};
    const Vec3d pushed = fluid.velocity[i] + dt * backend.accelerations()[i];
    for (std::size_t c = 0; c < 3; ++c) {
      matrix[3 * i + c][3 * i + c] += fluid.mass[i] + drag;
      right[3 * i + c] = component(fluid.mass[i] * pushed + carried, c);
    }
  }
  return solved(matrix, right);
}

TEST(ViscousMatrix, IsThatOfItsPower) {
  FlowModel model = viscous(1);
  model.gravity = {1, 0, -9.81};
  model.walls_move = true;
  OpenedReference backend(model);
  test::fill(backend, {}, 4);
  for (Vec3d& v : backend.boundary().velocity) v = {0.5, 0.1, 0};
  for (std::size_t i = 0; i < backend.fluid().size(); ++i)
    backend.fluid().viscosity[i] = 1 + 50 * (i % 3);
  prepare(backend);
  const double dt = 0.01;
  const std::vector<double> expected = dense_step(backend, backend.fluid(), dt);
  ASSERT_TRUE(advance_velocity(backend, dt, 1e-12, 1000).converged);
  for (std::size_t i = 0; i < backend.fluid().size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(component(backend.fluid().velocity[i], c), expected[3 * i + c], 1e-9);
}

/// Power that the viscosity of a free cube, 8 particles wide, takes from the velocities `at(x)`, W.
template <class Velocity>
double viscous_power(const test::On kind, const Velocity& at) {
  const FlowModel model = viscous(1);
  auto backend = test::make_backend(kind, model);
  test::add_block(backend->fluid(), model, {0, 8, 0, 8, 0, 8});
  backend->boundary().resize(0);
  Particles& fluid = backend->fluid();
  set_viscosity(fluid, 1);
  for (std::size_t i = 0; i < fluid.size(); ++i) fluid.velocity[i] = at(fluid.position[i]);
  prepare(*backend);
  const double before = kinetic_energy_of(fluid), dt = 1e-3;  // 0.01 of the viscous time dp^2/nu
  EXPECT_TRUE(advance_velocity(*backend, dt, 1e-9, 500).converged);
  return (before - kinetic_energy_of(backend->fluid())) / dt;
}

// The stress is mu (grad v + grad v^T): a fluid that is squeezed in a plane takes as much power as
// one that is sheared at the same rate, sqrt(2 eps : eps), and one that turns takes none. With
// mu grad v it would be a half and one.
TEST(ViscousMatrix, TakesThePowerOfTheRateOfStrain) {
  for (const test::On kind : test::backends()) {
    const double sheared = viscous_power(kind, [](const Vec3d& x) { return Vec3d{2 * x.z, 0, 0}; });
    EXPECT_GT(sheared, 0);
    const double squeezed = viscous_power(kind, [](const Vec3d& x) { return Vec3d{x.x, 0, -x.z}; });
    EXPECT_NEAR(squeezed / sheared, 1, 0.02);
    const double turned = viscous_power(kind, [](const Vec3d& x) { return Vec3d{x.z, 0, -x.x}; });
    EXPECT_NEAR(turned / sheared, 0, 0.02);
  }
}

}  // namespace
}  // namespace sabo
