#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "support/backends.hpp"
#include "support/clouds.hpp"
#include "support/scenes.hpp"
#include "support/viscous_step.hpp"
#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.hpp"
#include "backend/reference/reference_backend.hpp"

namespace sabo {
namespace {

using test::Cloud;
using test::difference;
using test::offset_of;

/// A backend whose sums about walls can be seen.
template <class Base>
struct Opened : Base {
  using Base::Base;
  using Base::filling_;
  using Base::strain_;
  using Base::support_;
  using Base::wall_drag_;
  using Base::wall_share_;
};

/// Results of every sweep of one implicit step by particle id, since backends sort.
struct Step {
  std::map<std::uint32_t, Vec3d> acceleration, velocity, drag, position;
  std::map<std::uint32_t, double> density_rate, density, pressure, viscosity, wall_pressure;
  double heat = 0;
  // Of a backend that is opened.
  std::map<std::uint32_t, Vec3d> gradient, emptiness, wall_velocity;
  std::map<std::uint32_t, double> share, filling, resistance, strain, support;
};

template <class B>
constexpr bool is_open = requires(B& backend) {
  backend.wall_share_;
};

void keep_forces(const auto& backend, const Particles& fluid, const std::vector<Vec3d>& a,
                 Step& step) {
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const std::uint32_t id = fluid.id[i];
    step.acceleration[id] = a[i];
    if constexpr (is_open<decltype(backend)>) {
      step.share[id] = backend.wall_share_[i].share;
      step.gradient[id] = backend.wall_share_[i].gradient;
      step.wall_velocity[id] = backend.wall_share_[i].velocity;
      step.filling[id] = backend.filling_[i].share;
      step.emptiness[id] = backend.filling_[i].gradient;
      step.resistance[id] = backend.wall_drag_[i];
    }
  }
}

void keep_motion(const auto& backend, const Particles& fluid, const std::vector<double>& rates,
                 Step& step) {
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const std::uint32_t id = fluid.id[i];
    step.velocity[id] = fluid.velocity[i];
    step.drag[id] = fluid.drag[i];
    step.density_rate[id] = rates[i];
    if constexpr (is_open<decltype(backend)>) {
      step.strain[id] = std::sqrt(double_dot(backend.strain_[i], backend.strain_[i]));
      step.support[id] = backend.support_[i];
    }
  }
}

template <class B>
Step step_of(B&& backend, Cloud cloud) {
  test::fill(backend, offset_of(cloud, backend.model()));
  // Some viscosity to start from, different everywhere.
  Particles& start = backend.fluid();
  for (std::size_t i = 0; i < start.size(); ++i)
    start.viscosity[i] = 5 + 4 * std::sin(double(start.id[i]));
  if (backend.model().walls_move)
    for (Vec3d& v : backend.boundary().velocity) v = {0.3, 0, 0.1};
  Step step;
  backend.find_neighbours();
  backend.pressure();
  std::map<std::uint32_t, double> before;
  for (std::size_t b = 0; b < backend.boundary().size(); ++b)
    before[backend.boundary().id[b]] = backend.boundary().density[b];
  backend.wall_pressure();
  for (std::size_t b = 0; b < backend.boundary().size(); ++b) {
    const std::uint32_t id = backend.boundary().id[b];
    if (backend.boundary().density[b] != before[id])
      step.wall_pressure[id] = backend.boundary().pressure[b];
  }
  backend.near_forces();
  backend.wall_resistance();
  keep_forces(backend, backend.fluid(), backend.accelerations(), step);
  const ViscousSolve solve = test::advance_velocity(backend, 2e-3, 1e-8, 400);
  EXPECT_TRUE(solve.converged);
  step.heat = backend.heat().viscosity;
  backend.near_motion();
  keep_motion(backend, backend.fluid(), backend.density_rates(), step);
  backend.advance_state();
  const Particles& fluid = backend.fluid();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const std::uint32_t id = fluid.id[i];
    step.position[id] = fluid.position[i] - offset_of(cloud, backend.model());
    step.density[id] = fluid.density[i] - backend.model().state.rho0;
    step.pressure[id] = fluid.pressure[i];
    step.viscosity[id] = fluid.viscosity[i];
  }
  return step;
}

void expect_close(const Step& a, const Step& b) {
  constexpr double tolerance = 1e-5;
  const auto size = [](double x) { return std::abs(x); };
  EXPECT_LT(difference(a.acceleration, b.acceleration, norm<double>), tolerance);
  EXPECT_LT(difference(a.velocity, b.velocity, norm<double>), tolerance);
  EXPECT_LT(difference(a.drag, b.drag, norm<double>), 10 * tolerance);  // a difference over dt
  EXPECT_LT(difference(a.density_rate, b.density_rate, size), 2 * tolerance);
  EXPECT_LT(difference(a.position, b.position, norm<double>), tolerance);
  EXPECT_LT(difference(a.density, b.density, size), tolerance);
  EXPECT_LT(difference(a.pressure, b.pressure, size), tolerance);
  EXPECT_LT(difference(a.viscosity, b.viscosity, size), 10 * tolerance);
  EXPECT_NEAR(b.heat / a.heat, 1, 1e-4);
  EXPECT_GT(a.wall_pressure.size(), 8u);
  for (const auto& [id, p] : a.wall_pressure) {
    ASSERT_TRUE(b.wall_pressure.count(id));
    EXPECT_NEAR(b.wall_pressure.at(id), p, tolerance * 12000);  // rho c0^2 x 2 %
  }
}

void expect_close_within(const Step& a, const Step& b) {
  constexpr double tolerance = 1e-5;
  const auto size = [](double x) { return std::abs(x); };
  EXPECT_LT(difference(a.share, b.share, size), tolerance);
  EXPECT_LT(difference(a.gradient, b.gradient, norm<double>), tolerance);
  EXPECT_LT(difference(a.filling, b.filling, size), tolerance);
  EXPECT_LT(difference(a.emptiness, b.emptiness, norm<double>), tolerance);
  EXPECT_LT(difference(a.resistance, b.resistance, size), tolerance);
  EXPECT_LT(difference(a.strain, b.strain, size), tolerance);
  EXPECT_LT(difference(a.support, b.support, size), tolerance);
  for (const auto& [id, v] : a.wall_velocity)
    EXPECT_LT(norm(v - b.wall_velocity.at(id)), tolerance);
}

FlowModel model_of(int dimension, const WallShear& wall) {
  FlowModel model;
  model.dimension = dimension;
  model.spacing = 0.1;
  model.h = 0.15;
  model.state = {1500, 20};
  model.rheology = Cross{2, 100, 1};
  model.yield = {10, 25, 0.3};
  model.diffusion_form = DiffusionForm::fourtakas;
  model.wall = wall;
  model.threads = 1;
  return model;
}

void expect_steps_agree(const FlowModel& plain, Cloud cloud) {
  const FlowModel model = test::in_cloud(plain, cloud);
  const Step expected = step_of(Opened<ReferenceBackend>(model), cloud);
  for (const PairSweeps* sweeps : all_pair_sweeps()) {
    SCOPED_TRACE(sweeps->instruction_set);
    const Step found = step_of(Opened<CpuBackend>(model, *sweeps), cloud);
    expect_close(expected, found);
    expect_close_within(expected, found);
  }
  for (const test::On on : {test::On::device, test::On::cuda}) {
    if (on == test::On::cuda && !test::cuda_is_missing().empty()) continue;
    SCOPED_TRACE(test::word_of(on));
    expect_close(expected, step_of(*test::make_backend(on, model), cloud));
  }
  SCOPED_TRACE("device, opened");
  expect_close_within(expected, step_of(Opened<test::DeviceOnHost>(model), cloud));
}

class ImplicitSweeps : public testing::TestWithParam<std::tuple<int, Cloud, WallShear>> {};

TEST_P(ImplicitSweeps, AgreeToSinglePrecision) {
  const auto& [dimension, cloud, wall] = GetParam();
  expect_steps_agree(model_of(dimension, wall), cloud);
}

INSTANTIATE_TEST_SUITE_P(PlacesAndWalls, ImplicitSweeps,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(Cloud::free, Cloud::periodic, Cloud::far),
                                          testing::Values(WallShear{NoSlip{}},
                                                          WallShear{Coulomb{2, 0}},
                                                          WallShear{Voellmy{{5, 0.2}, 300}})));

TEST(ImplicitSweeps, AgreeForEveryOtherSwitch) {
  FlowModel artificial = model_of(3, NoSlip{});
  artificial.artificial_viscosity = 0.05;
  FlowModel moving = model_of(3, NoSlip{});
  moving.walls_move = true;
  FlowModel printed = model_of(3, NoSlip{});
  printed.as_printed = true;
  printed.diffusion_form = DiffusionForm::molteni;
  FlowModel shifted = model_of(3, NoSlip{});
  shifted.particle_shifting = 20;
  FlowModel torn = model_of(3, NoSlip{});
  torn.tension_at_surface = false;
  FlowModel central = model_of(3, NoSlip{});
  central.central = {30, {0.2, 0.5, -0.4}};
  for (const FlowModel& model : {artificial, moving, printed, shifted, torn, central})
    expect_steps_agree(model, Cloud::free);
}

}  // namespace
}  // namespace sabo
