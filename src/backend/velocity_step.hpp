#pragma once

#include "backend/chosen_step.hpp"
#include "backend/flow_view.hpp"
#include "backend/heat_account.hpp"
#include "backend/store_sum.hpp"
#include "backend/sweeps/flow_sums.hpp"
#include "backend/viscous_solver.hpp"
#include "physics/pair/viscous_flux.hpp"

namespace sabo {

/// What the implicit step of velocity works on.
template <class T>
struct VelocityView {
  FlowView flow;
  SolverView<T> solver;
  const T* conductance_sum;
  Vec3d* guess;
  T* mass;
  T* drag;
  const ChosenStep* step;

  SABO_HD double dt() const { return step->dt; }
  SABO_HD Vec3d pushed(std::size_t i) const {
    return flow.fluid.velocity[i] + dt() * flow.acceleration[i];
  }
};

/// The guess keeps the viscous acceleration of the last step. Adds mass and wall drag over the
/// step, kg.
template <class T>
struct GuessVelocity {
  VelocityView<T> on;
  T* diagonal;
  SABO_HD void operator()(std::size_t k, Total& inertia) const {
    const std::size_t i = on.solver.rows[k];
    const Vec3d g = on.pushed(i) + on.dt() * on.flow.fluid.drag[i];
    on.guess[i] = g;
    on.solver.direction[i] = {T(g.x), T(g.y), T(g.z)};
    on.mass[i] = T(on.flow.fluid.mass[i]);
    on.drag[i] = T(on.flow.wall_drag[i]);
    diagonal[i] = on.mass[i] + T(on.dt()) * (on.conductance_sum[i] + on.drag[i]);
    inertia.value += on.flow.fluid.mass[i] + on.dt() * on.flow.wall_drag[i];
  }
};

/// A given velocity stands on the right-hand side; it is no unknown.
template <class T>
struct GiveVelocity {
  VelocityView<T> on;
  SABO_HD void operator()(std::size_t i) const {
    const Vec3d& v = on.flow.fluid.velocity[i];
    on.solver.direction[i] = {T(v.x), T(v.y), T(v.z)};
  }
};
template <class T>
struct WithdrawVelocity {
  VelocityView<T> on;
  SABO_HD void operator()(std::size_t i) const { on.solver.direction[i] = {}; }
};

/// The residual of the guess, from the product of it with everything but the masses.
template <class T>
struct FindResidual {
  VelocityView<T> on;
  SABO_HD Quad<T> operator()(std::size_t i) const {
    const WallShare& wall = on.flow.wall[i];
    const double carried = wall.share > 0 ? on.dt() * on.flow.wall_drag[i] / wall.share : 0;
    const Vec3d r = on.flow.fluid.mass[i] * (on.pushed(i) - on.guess[i]) + carried * wall.velocity;
    const Quad<T>& q = on.solver.product[i];
    return {T(r.x) - q.x, T(r.y) - q.y, T(r.z) - q.z};
  }
};

/// Kinetic energy that viscosity and walls took, J.
struct ViscousHeat {
  double value = 0;
  SABO_HD void join(const ViscousHeat& other) { value += other.value; }
  SABO_HD void enter(HeatAccount& account) const { account.viscosity += value; }
};

/// The new velocity, with what the solve has left undone as one change for all, and the viscous
/// force times the mean velocity of the step, J. With what it takes from the pushed velocity, the
/// heat of a creeping flow would be that of dt g, which it never reaches.
template <class T>
struct TakeVelocity {
  VelocityView<T> on;
  Vec3d left;  ///< undone, kg m/s
  const Total* inertia;
  SABO_HD void operator()(std::size_t k, ViscousHeat& heat) const {
    const Vec3d owed = inertia->value > 0 ? (1 / inertia->value) * left : Vec3d{};
    const std::size_t i = on.solver.rows[k];
    const Quad<T>& c = on.solver.change[i];
    Vec3d& velocity = on.flow.fluid.velocity[i];
    const Vec3d before = on.pushed(i);
    const Vec3d after = on.guess[i] + Vec3d{double(c.x), double(c.y), double(c.z)} + owed;
    heat.value += 0.5 * on.flow.fluid.mass[i] * dot(before - after, velocity + after);
    on.flow.fluid.drag[i] = (1 / on.dt()) * (after - before);
    velocity = after;
  }
};

/// How small the residual has to become, m/s.
struct FindTolerance {
  VelocityTolerance tolerance;
  const ChosenStep* step;
  SABO_HD double operator()() const { return tolerance.over(*step); }
};

/// Backward Euler of viscosity and wall resistance with coefficients of the last step:
///   (M + dt K + dt D) v' = M (v + dt a) + dt D w,
/// solved for the change from a guess that keeps the viscous acceleration of the last step.
template <class T, class Executor = HostExecutor>
class VelocityStep {
 public:
  using Numbers = typename Executor::template Array<T>;

  Numbers conductance_sum;  ///< of each particle, kg/s, in
  /// Of the moments of the conductances (physics/pair/viscous_flux.hpp), for the product.
  typename Executor::template Array<Sym3<T>> inverse_root;
  ViscousSolver<T, Executor> solver;

  /// All rows start from zero.
  void reset(const Executor& on, std::size_t particles) {
    for (Numbers* numbers : {&conductance_sum, &mass_, &drag_, &none_})
      on.zero(*numbers, particles);
    on.zero(inverse_root, particles);
    on.zero(guess_, particles);
    on.zero(inertia_, 1);
    solver.reset(on, particles);
  }

  /// `multiply(mass, drag, progress)` sets solver.product to (mass + dt K + dt drag)
  /// solver.direction, and solver.curvature; masses in kg, drags of the walls in kg/s. It may
  /// leave that out once `progress`, where there is one, has ended. `step` is where the flow is.
  /// Driven particles keep their velocity; particles in neither list are at rest. Once
  /// the solve has converged, take_heat(ViscousHeat) is called where the flow is.
  template <class Multiply, class TakeHeat>
  ViscousSolve advance(const Executor& on, const FlowView& flow, RowList rows, RowList driven,
                       const ChosenStep* step, const VelocityTolerance& tolerance,
                       int most_iterations, const Multiply& multiply, const TakeHeat& take_heat) {
    const VelocityView<T> view{flow,
                               solver.view(rows, mass_.data()),
                               conductance_sum.data(),
                               guess_.data(),
                               mass_.data(),
                               drag_.data(),
                               step};
    on.template sum_up<Total>(rows.count, GuessVelocity<T>{view, solver.diagonal.data()},
                              StoreSum<Total>{inertia_.data()});
    on.for_each(driven.count, AtRow<GiveVelocity<T>>{driven.index, {view}});
    multiply(none_.data(), drag_.data(), nullptr);
    on.for_each(driven.count, AtRow<WithdrawVelocity<T>>{driven.index, {view}});
    const auto multiply_all = [&](const SolveProgress<T>* progress) {
      multiply(mass_.data(), drag_.data(), progress);
    };
    const ViscousSolve outcome =
        solver.solve(on, rows, mass_.data(), FindResidual<T>{view}, FindTolerance{tolerance, step},
                     most_iterations, multiply_all);
    if (!outcome.converged) return outcome;
    // The coarse correction by the constant vector (Nicolaides 1987), after which the residuals add
    // up to zero. Viscosity within the flow then conserves momentum to rounding, whatever the
    // tolerance.
    const TakeVelocity<T> take{view, solver.residual_sum, inertia_.data()};
    on.template sum_up<ViscousHeat>(rows.count, take, take_heat);
    return outcome;
  }

  /// Memory of the vectors.
  std::size_t bytes() const {
    constexpr std::size_t each = 4 * sizeof(T) + sizeof(Sym3<T>) + sizeof(Vec3d);
    return each * guess_.size() + solver.bytes();
  }

 private:
  Numbers mass_, drag_, none_;
  typename Executor::template Array<Vec3d> guess_;
  typename Executor::template Array<Total> inertia_;  // one
};

}  // namespace sabo
