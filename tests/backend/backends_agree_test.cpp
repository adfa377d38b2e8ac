#include <map>
#include <memory>
#include <tuple>

#include "support/backends.hpp"
#include "support/clouds.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.hpp"
#include "backend/reference/reference_backend.hpp"

namespace sabo {
namespace {

using test::add_particle;
using test::Cloud;
using test::difference;
using test::fill;
using test::in_cloud;
using test::offset_of;
using test::On;

/// The switches of a run that change which sums are taken.
struct Switches {
  ViscousOperator op = ViscousOperator::nested;
  BoundaryStress wall = BoundaryStress::own;
  bool artificial = true;
  DiffusionForm diffusion = DiffusionForm::fourtakas;
  bool as_printed = false;
  int dimension = 3;
};

FlowModel model_of(const Switches& switches) {
  FlowModel model;
  model.dimension = switches.dimension;
  model.spacing = 0.1;
  model.h = 0.15;
  model.state = {1500, 20};
  model.rheology = Cross{2, 100, 1};
  model.yield = {10, 25, 0.3};
  model.viscous_operator = switches.op;
  model.boundary_stress = switches.wall;
  model.artificial_viscosity = switches.artificial ? 0.05 : 0;
  model.diffusion_form = switches.diffusion;
  model.as_printed = switches.as_printed;
  model.threads = 1;
  return model;
}

/// Rates by particle id, since backends sort.
struct Rates {
  std::map<std::uint32_t, Vec3d> acceleration;
  std::map<std::uint32_t, double> density_rate, viscosity;
  std::map<std::uint32_t, double> boundary_density_rate;
  double dissipation = 0;
};

Rates rates_of(Backend& backend) {
  backend.find_neighbours();
  backend.pressure();
  backend.strain_and_density_rates();
  backend.stress();
  backend.momentum();
  Rates rates;
  const std::size_t fluids = backend.fluid().size();
  for (std::size_t i = 0; i < fluids; ++i) {
    const std::uint32_t id = backend.fluid().id[i];
    rates.acceleration[id] = backend.accelerations()[i];
    rates.density_rate[id] = backend.density_rates()[i];
    rates.viscosity[id] = backend.fluid().viscosity[i];
  }
  for (std::size_t i = 0; i < backend.boundary().size(); ++i)
    rates.boundary_density_rate[backend.boundary().id[i]] = backend.density_rates()[fluids + i];
  rates.dissipation = test::dissipated_power(backend);
  return rates;
}

Rates rates_in(std::unique_ptr<Backend> backend, Cloud cloud) {
  fill(*backend, offset_of(cloud, backend->model()));
  return rates_of(*backend);
}

void expect_close(const Rates& a, const Rates& b, double tolerance) {
  const auto absolute = [](double x) { return std::abs(x); };
  EXPECT_LT(difference(a.acceleration, b.acceleration, norm<double>), tolerance);
  EXPECT_LT(difference(a.density_rate, b.density_rate, absolute), tolerance);
  EXPECT_LT(difference(a.boundary_density_rate, b.boundary_density_rate, absolute), tolerance);
  EXPECT_LT(difference(a.viscosity, b.viscosity, absolute), 10 * tolerance);
  EXPECT_NEAR(b.dissipation / a.dissipation, 1, 100 * tolerance);
}

void expect_every_backend_agrees(const FlowModel& plain, Cloud cloud) {
  const FlowModel model = in_cloud(plain, cloud);
  const Rates expected = rates_in(std::make_unique<ReferenceBackend>(model), cloud);
  for (const PairSweeps* sweeps : all_pair_sweeps()) {
    SCOPED_TRACE(sweeps->instruction_set);
    expect_close(expected, rates_in(std::make_unique<CpuBackend>(model, *sweeps), cloud), 2e-6);
  }
  for (const On on : test::backends()) {
    SCOPED_TRACE(test::word_of(on));
    expect_close(expected, rates_in(test::make_backend(on, model), cloud), 2e-6);
  }
}

class Backends : public testing::TestWithParam<std::tuple<ViscousOperator, BoundaryStress, Cloud>> {
};

TEST_P(Backends, AgreeToSinglePrecision) {
  const auto [op, wall, cloud] = GetParam();
  expect_every_backend_agrees(model_of({op, wall}), cloud);
}

INSTANTIATE_TEST_SUITE_P(
    OperatorsAndWalls, Backends,
    testing::Combine(testing::Values(ViscousOperator::nested, ViscousOperator::morris),
                     testing::Values(BoundaryStress::own, BoundaryStress::mirror,
                                     BoundaryStress::none),
                     testing::Values(Cloud::free, Cloud::periodic, Cloud::far)));

TEST(Backends, AgreeForEveryOtherSwitch) {
  Switches plain;
  plain.artificial = false;
  plain.diffusion = DiffusionForm::molteni;
  Switches plain_morris = plain;
  plain_morris.op = ViscousOperator::morris;
  Switches printed = plain;
  printed.as_printed = true;
  Switches printed_morris = plain_morris;
  printed_morris.as_printed = true;
  Switches flat;
  flat.dimension = 2;
  for (const Switches& switches : {plain, plain_morris, printed, printed_morris, flat})
    for (const Cloud cloud : {Cloud::free, Cloud::periodic})
      expect_every_backend_agrees(model_of(switches), cloud);
  FlowModel central = model_of({});
  central.central = {30, {0.2, 0.5, -0.4}};
  for (const Cloud cloud : {Cloud::free, Cloud::far}) expect_every_backend_agrees(central, cloud);
}

TEST(CpuBackend, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto with_threads = [](int threads) {
    FlowModel model = model_of({});
    model.threads = threads;
    auto backend = std::make_unique<CpuBackend>(model);
    fill(*backend, {}, 30);  // 5400 fluid particles: enough for every loop to be shared
    EXPECT_GT(backend->fluid().size(), static_cast<std::size_t>(worth_threads));
    const Rates rates = rates_of(*backend);
    backend->fix_step(1e-3);
    backend->predict();
    backend->correct();
    return std::tuple(rates.acceleration, rates.density_rate, rates.dissipation,
                      backend->fluid().position, backend->fluid().density);
  };
  const auto one = with_threads(1);
  for (const int threads : {2, 3, 7}) EXPECT_TRUE(with_threads(threads) == one) << threads;
}

TEST(Boundary, TakesThePressureOfTheFluidCarriedAlongGravity) {
  for (const On on : test::backends()) {
    auto backend = test::make_backend(on, model_of({}));
    add_particle(backend->fluid(), backend->model(), {0, 0, 0.1});
    add_particle(backend->boundary(), backend->model(), {0, 0, 0});
    add_particle(backend->boundary(), backend->model(), {5, 0, 0});
    backend->fluid().density[0] = 1501;
    backend->find_neighbours();
    backend->pressure();
    backend->extrapolate_to_boundary();
    const Tait state = backend->model().state;
    // 0.1 m deeper than the only neighbour; the other one has none and keeps its density.
    const double expected = state.density(state.pressure(1501) + 1501 * 9.81 * 0.1);
    for (std::size_t b = 0; b < 2; ++b)
      EXPECT_NEAR(backend->boundary().density[b],
                  backend->boundary().position[b].x < 1 ? expected : 1500, 1e-9);
  }
}

TEST(Backends, RefuseAPeriodShorterThanTwoKernels) {
  FlowModel model = model_of({});
  model.periodic.period[0] = {0.65, 0, 0};  // 4.33 h; two images fit below 4.4 h
  for (const On on : test::backends()) {
    if (on == On::reference) continue;
    EXPECT_ANY_THROW(test::make_backend(on, model)) << test::word_of(on);
  }
}

TEST(Momentum, IsConservedByTheInternalForces) {
  for (const auto op : {ViscousOperator::nested, ViscousOperator::morris}) {
    FlowModel model = model_of({op});
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

// Tests that go through backends() say nothing of one that is missing here.
TEST(Backends, AreAllThere) {
  if (!test::cuda_is_missing().empty())
    GTEST_SKIP() << "tests of all backends leave cuda out: " << test::cuda_is_missing();
  EXPECT_EQ(test::backends().size(), std::size(test::all_backends));
}

TEST(Extremes, LeaveOutAParticleInFreeFlight) {
  for (const On on : test::backends()) {
    auto backend = test::make_backend(on, model_of({}));
    fill(*backend, {});
    add_particle(backend->fluid(), backend->model(), {5, 5, 5}, {0, 0, -100});
    backend->find_neighbours();
    EXPECT_LT(backend->fastest(), 2);
    backend->fix_step(1e-3);
    EXPECT_LT(backend->chosen_step().flow.speed, 2);
  }
}

}  // namespace
}  // namespace sabo
