#include <algorithm>
#include <map>
#include <random>

#include "support/scenes.hpp"
#include <gtest/gtest.h>

namespace sabo {
namespace {

using test::add_particle;

enum class Cloud { free, periodic, far };

/// A model that switches every term on.
FlowModel rich_model(ViscousOperator op, BoundaryStress wall) {
  FlowModel model;
  model.spacing = 0.1;
  model.h = 0.15;
  model.state = {1500, 20};
  model.rheology = Cross{2, 100, 1};
  model.yield = {10, 25, 0.3};
  model.viscous_operator = op;
  model.boundary_stress = wall;
  model.artificial_viscosity = 0.05;
  model.diffusion_form = DiffusionForm::fourtakas;
  return model;
}

/// A jittered block over a jittered floor, every particle with its own velocity, density and mass.
void fill(Backend& backend, const Vec3d& offset) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const double dp = backend.model().spacing;
  for (int k = -3; k < 6; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        Particles& set = k < 0 ? backend.boundary() : backend.fluid();
        const Vec3d jitter{0.2 * dp * u(random), 0.2 * dp * u(random), 0.2 * dp * u(random)};
        add_particle(set, backend.model(),
                     offset + Vec3d{(i + 0.5) * dp, (j + 0.5) * dp, (k + 0.5) * dp} + jitter,
                     k < 0 ? Vec3d{} : Vec3d{u(random), u(random), u(random)});
        set.density.back() *= 1 + 0.02 * u(random);
        set.mass.back() *= 1 + 0.1 * u(random);
      }
}

struct Rates {
  Vec3d acceleration;
  double density_rate, viscosity, dissipation;
};

/// Rates by particle id, since backends sort.
std::map<std::uint32_t, Rates> rates(BackendKind kind, FlowModel model, Cloud cloud,
                                     int threads = 1) {
  model.threads = threads;
  Vec3d offset;
  if (cloud == Cloud::far) offset = {10240.0, -10240.0, 1024.0};  // exact in binary
  if (cloud == Cloud::periodic)
    model.periodic.period = {Vec3d{0.8, 0, -0.2}, Vec3d{0, 0.8, 0}, Vec3d{}};
  auto backend = make_backend(kind, model);
  fill(*backend, offset);
  backend->find_neighbours();
  backend->pressure();
  backend->strain_and_density_rates();
  backend->stress();
  backend->momentum();
  std::map<std::uint32_t, Rates> result;
  for (std::size_t i = 0; i < backend->fluid().size(); ++i)
    result[backend->fluid().id[i]] = {backend->accelerations()[i], backend->density_rates()[i],
                                      backend->fluid().viscosity[i], backend->dissipation()};
  return result;
}

void expect_close(const std::map<std::uint32_t, Rates>& a, const std::map<std::uint32_t, Rates>& b,
                  double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  double largest = 0, difference = 0, largest_rate = 0, rate_difference = 0;
  for (const auto& [id, expected] : a) {
    const Rates& found = b.at(id);
    largest = std::max(largest, norm(expected.acceleration));
    difference = std::max(difference, norm(expected.acceleration - found.acceleration));
    largest_rate = std::max(largest_rate, std::abs(expected.density_rate));
    rate_difference =
        std::max(rate_difference, std::abs(expected.density_rate - found.density_rate));
    EXPECT_NEAR(found.viscosity / expected.viscosity, 1, 1e-4);
    EXPECT_NEAR(found.dissipation / expected.dissipation, 1, 1e-4);
  }
  EXPECT_GT(largest, 10);  // the test is about something
  EXPECT_LT(difference, tolerance * largest);
  EXPECT_LT(rate_difference, tolerance * largest_rate);
}

class Backends : public testing::TestWithParam<std::tuple<ViscousOperator, BoundaryStress, Cloud>> {
};

TEST_P(Backends, AgreeOnEveryRateToSinglePrecision) {
  const auto [op, wall, cloud] = GetParam();
  const FlowModel model = rich_model(op, wall);
  expect_close(rates(BackendKind::reference, model, cloud), rates(BackendKind::cpu, model, cloud),
               2e-6);
}

INSTANTIATE_TEST_SUITE_P(
    AllSwitches, Backends,
    testing::Combine(testing::Values(ViscousOperator::nested, ViscousOperator::morris),
                     testing::Values(BoundaryStress::own, BoundaryStress::mirror,
                                     BoundaryStress::none),
                     testing::Values(Cloud::free, Cloud::periodic, Cloud::far)));

TEST(CpuBackend, GivesTheSameBitsForAnyNumberOfThreads) {
  const FlowModel model = rich_model(ViscousOperator::nested, BoundaryStress::own);
  const auto one = rates(BackendKind::cpu, model, Cloud::free, 1);
  for (const int threads : {2, 3, 7}) {
    const auto many = rates(BackendKind::cpu, model, Cloud::free, threads);
    for (const auto& [id, expected] : one) {
      EXPECT_EQ(many.at(id).acceleration, expected.acceleration);
      EXPECT_EQ(many.at(id).density_rate, expected.density_rate);
      EXPECT_EQ(many.at(id).dissipation, expected.dissipation);
    }
  }
}

TEST(CpuBackend, RefusesAPeriodShorterThanTwoKernels) {
  FlowModel model = rich_model(ViscousOperator::nested, BoundaryStress::own);
  model.periodic.period[0] = {0.6, 0, 0};  // 4 h; the list needs 4.2 h
  EXPECT_ANY_THROW(make_backend(BackendKind::cpu, model));
}

TEST(Momentum, IsConservedByTheInternalForces) {
  for (const auto op : {ViscousOperator::nested, ViscousOperator::morris}) {
    FlowModel model = rich_model(op, BoundaryStress::own);
    model.gravity = {};
    auto backend = make_backend(BackendKind::reference, model);
    fill(*backend, {});
    backend->boundary().resize(0);
    backend->find_neighbours();
    backend->pressure();
    backend->strain_and_density_rates();
    backend->stress();
    backend->momentum();
    Vec3d sum;
    double largest = 0;
    for (std::size_t i = 0; i < backend->fluid().size(); ++i) {
      const Vec3d force = backend->fluid().mass[i] * backend->accelerations()[i];
      sum += force;
      largest = std::max(largest, norm(force));
    }
    EXPECT_LT(norm(sum), 1e-11 * largest);
  }
}

TEST(Extremes, LeaveOutAParticleInFreeFlight) {
  for (const auto kind : {BackendKind::reference, BackendKind::cpu}) {
    auto backend = make_backend(kind, rich_model(ViscousOperator::nested, BoundaryStress::own));
    fill(*backend, {});
    add_particle(backend->fluid(), backend->model(), {5, 5, 5}, {0, 0, -100});
    backend->find_neighbours();
    EXPECT_LT(backend->extremes().speed, 2);
  }
}

}  // namespace
}  // namespace sabo
