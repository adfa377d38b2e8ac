#pragma once

#include <vector>

#include "backend/host_loops.hpp"
#include "backend/viscous_solver.hpp"
#include "backend/wall_share.hpp"
#include "particles/particles.hpp"

namespace sabo {

/// What the implicit step of velocity starts from; arrays by particle.
struct VelocityProblem {
  Particles& fluid;
  const std::vector<std::uint32_t>& rows;    ///< particles that move; the others are at rest
  const std::vector<std::uint32_t>& driven;  ///< or driven: they keep the velocity they have
  const std::vector<Vec3d>& acceleration;    ///< without viscosity, m/s2
  const std::vector<WallShare>& wall;
  const std::vector<double>& wall_drag;  ///< kg/s
  double dt;
  double tolerance;  ///< m/s
  int most_iterations;
  int threads;
};

/// Backward Euler of viscosity and wall resistance with coefficients of the last step:
///   (M + dt K + dt D) v' = M (v + dt a) + dt D w,
/// solved for the change from a guess that keeps the viscous acceleration of the last step.
template <class T>
class VelocityStep {
 public:
  using Dot = typename ViscousSolver<T>::Dot;

  std::vector<T> conductance_sum;  ///< row sums of -K off its diagonal, kg/s, in

  /// What the product needs to know.
  std::vector<T> mass;  ///< kg
  std::vector<T> drag;  ///< kg/s
  ViscousSolver<T> solver;

  /// All rows start from zero.
  void reset(std::size_t particles) {
    conductance_sum.assign(particles, T(0));
    mass.assign(particles, T(0));
    drag.assign(particles, T(0));
    none_.assign(particles, T(0));
    guess_.assign(particles, {});
    solver.reset(particles);
  }

  /// `multiply(mass, drag)` sets solver.product to (mass + dt K + dt drag) solver.direction and
  /// returns their scalar product.
  template <class Multiply>
  ViscousSolve advance(const VelocityProblem& problem, const Multiply& multiply) {
    const double dt = problem.dt;
    Particles& fluid = problem.fluid;
    const auto pushed = [&](std::size_t i) {
      return fluid.velocity[i] + dt * problem.acceleration[i];
    };
    over_rows(problem.rows, problem.threads, [&](std::size_t i) {
      guess_[i] = pushed(i) + dt * fluid.drag[i];
      const Vec3d& g = guess_[i];
      solver.direction[i] = {T(g.x), T(g.y), T(g.z)};
      mass[i] = T(fluid.mass[i]);
      drag[i] = T(problem.wall_drag[i]);
      solver.diagonal[i] = mass[i] + T(dt) * (conductance_sum[i] + drag[i]);
    });
    // A given velocity stands on the right-hand side; it is no unknown.
    for (const std::uint32_t i : problem.driven) {
      const Vec3d& v = fluid.velocity[i];
      solver.direction[i] = {T(v.x), T(v.y), T(v.z)};
    }
    multiply(none_, drag);
    for (const std::uint32_t i : problem.driven) solver.direction[i] = {};
    over_rows(problem.rows, problem.threads, [&](std::size_t i) {
      const double share = problem.wall[i].share;
      const double carried = share > 0 ? dt * problem.wall_drag[i] / share : 0;
      const Vec3d r = fluid.mass[i] * (pushed(i) - guess_[i]) + carried * problem.wall[i].velocity;
      const Quad<T>& q = solver.product[i];
      solver.residual[i] = {T(r.x) - q.x, T(r.y) - q.y, T(r.z) - q.z};
    });

    ViscousSolve outcome =
        solver.solve(problem.rows, mass, problem.tolerance, problem.most_iterations,
                     problem.threads, [&] { return multiply(mass, drag); });
    if (!outcome.converged) return outcome;
    const Vec3d owed = common_change(problem);
    heat_.resize(problem.rows.size());
    over(problem.rows.size(), problem.threads, [&](std::size_t k) {
      const std::size_t i = problem.rows[k];
      const Quad<T>& c = solver.change[i];
      const Vec3d before = pushed(i);
      const Vec3d after = guess_[i] + Vec3d{double(c.x), double(c.y), double(c.z)} + owed;
      // The viscous force times the mean velocity of the step. With what it takes from the pushed
      // velocity, the heat of a creeping flow would be that of dt g, which it never reaches.
      heat_[k] = 0.5 * fluid.mass[i] * dot(before - after, fluid.velocity[i] + after);
      fluid.drag[i] = (1 / dt) * (after - before);
      fluid.velocity[i] = after;
    });
    outcome.heat =
        blocked_sum(heat_.size(), problem.threads, [this](std::size_t k) { return heat_[k]; });
    return outcome;
  }

 private:
  /// What the solve has left undone, as one change of velocity for all: the coarse correction by
  /// the constant vector (Nicolaides 1987), after which the residuals add up to zero. Viscosity
  /// within the flow then conserves momentum to rounding, whatever the tolerance.
  Vec3d common_change(const VelocityProblem& problem) {
    const double inertia =
        blocked_sum(problem.rows.size(), problem.threads, [&](std::size_t k) -> double {
          const std::size_t i = problem.rows[k];
          return problem.fluid.mass[i] + problem.dt * problem.wall_drag[i];
        });
    const Dot& left = solver.residual_sum;
    return inertia > 0 ? (1 / inertia) * Vec3d{left[0], left[1], left[2]} : Vec3d{};
  }

  std::vector<T> none_;
  std::vector<Vec3d> guess_;
  std::vector<double> heat_;
};

}  // namespace sabo
