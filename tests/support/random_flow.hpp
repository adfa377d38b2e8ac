#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "support/backends.hpp"
#include "support/scenes.hpp"

// Small flows with every choice of theirs drawn at random, for laws that hold for all.

namespace sabo::test {

class RandomFlow {
 public:
  /// Of size^3 particles.
  explicit RandomFlow(unsigned seed, int size = 5) : random_(seed) {
    model.dimension = flip() ? 3 : 2;
    method = flip() ? Method::fast : Method::paper;
    model.spacing = 0.1 * std::pow(2, uniform(-1, 1));
    model.h = uniform(1.2, 1.7) * model.spacing;
    model.state = {uniform(900, 2200), uniform(20, 40)};
    model.gravity = {uniform(-9, 9), is_flat() ? 0 : uniform(-9, 9), uniform(-9, 9)};
    if (chance(4)) model.central = {uniform(1, 20), {0.3, 0, 0.2}};
    const std::vector<Rheology> laws = all_rheologies();
    model.rheology = laws[below(laws.size())];
    model.yield = {uniform(0, 500), uniform(0, 40), uniform(0, 0.9)};
    model.diffusion_form = flip() ? DiffusionForm::molteni : DiffusionForm::fourtakas;
    model.artificial_viscosity = flip() ? 0 : uniform(0, 0.2);
    model.viscous_operator = flip() ? ViscousOperator::nested : ViscousOperator::morris;
    model.boundary_stress = BoundaryStress(below(3));
    model.boundary_pressure = flip() ? BoundaryPressure::dynamic : BoundaryPressure::extrapolated;
    const WallShear walls[] = {NoSlip{}, Slip{}, Coulomb{10, 0.4}, Voellmy{{0, 0.3}, 300}};
    model.wall = walls[below(4)];
    model.threads = 1;
    const int side = is_flat() ? static_cast<int>(std::lround(std::pow(size, 1.5))) : size;
    lay_out(fluid, side, 0, side);
    lay_out(walls_beneath, side, -model.wall_layers(), 0);
    const Vec3d spin = any_direction();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      fluid.velocity[i] = 0.2 / model.spacing * cross(spin, fluid.position[i]) + any_direction();
      fluid.density[i] *= 1 + 0.005 * uniform(-1, 1);
      fluid.mass[i] *= 1 + 0.1 * uniform(-1, 1);
    }
  }

  Method method;
  FlowModel model;
  Particles fluid, walls_beneath;

  bool is_flat() const { return model.dimension == 2; }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  bool chance(std::size_t in) { return below(in) == 0; }
  bool flip() { return chance(2); }

  /// Of length 1 or less, in the plane of a flow of two dimensions.
  Vec3d any_direction() {
    return {uniform(-0.6, 0.6), is_flat() ? 0 : uniform(-0.6, 0.6), uniform(-0.6, 0.6)};
  }

  std::vector<std::uint32_t> any_order(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(i);
    std::shuffle(order.begin(), order.end(), random_);
    return order;
  }

 private:
  void lay_out(Particles& particles, int across, int from, int to) {
    add_block(particles, model, {0, across, 0, across, from, to});
    for (Vec3d& x : particles.position) x += 0.2 * model.spacing * any_direction();
  }

  std::mt19937 random_;
};

/// A random flow on its way on a backend, in steps that no state of it shortens.
struct Moving {
  static constexpr double dt = 2e-5;  // s

  Moving(On on, const RandomFlow& flow, bool has_walls)
      : Moving(make_backend(on, flow.model), flow, has_walls) {}
  /// `made` is of the model of the flow, and empty.
  Moving(std::unique_ptr<Backend> made, const RandomFlow& flow, bool has_walls)
      : backend(std::move(made)) {
    backend->fluid() = flow.fluid;
    if (has_walls) backend->boundary() = flow.walls_beneath;
    if (flow.method == Method::fast) {
      FastRule rule = fast_rule_of(flow.model);
      rule.sound_follows_flow = false;
      rule.viscous_tolerance = 1e-6;  // laws are tried, not the default of this
      stepper = std::make_unique<FastStepper>(*backend, rule, nullptr);
    } else {
      stepper = std::make_unique<PaperStepper>(*backend, rule_of(flow.model), nullptr);
    }
  }

  void go(int steps) {
    for (int k = 0; k < steps; ++k) stepper->step(dt);
  }

  std::unique_ptr<Backend> backend;
  std::unique_ptr<Stepper> stepper;
};

}  // namespace sabo::test
