#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "backend/flow_view.hpp"
#include "backend/host_executor.hpp"
#include "backend/sweeps/flow_sums.hpp"
#include "backend/viscous_solve.hpp"
#include "math/quad.hpp"
#include "math/scalar.hpp"

namespace sabo {

/// What an iteration wants to know of the residual.
struct ResidualSums {
  double energy = 0;  ///< residual . residual / diagonal
  Vec3d size;         ///< |residual / mass|^2 by component
  Vec3d residual;     ///< sum
  SABO_HD void join(const ResidualSums& other) {
    energy += other.energy;
    size += other.size;
    residual += other.residual;
  }
  SABO_HD double largest() const { return larger(size.x, larger(size.y, size.z)); }
};

/// Where the vectors of the solver are.
template <class T>
struct SolverView {
  const std::uint32_t* rows;
  const T* mass;
  const T* diagonal;
  Quad<T>* change;
  Quad<T>* residual;
  Quad<T>* direction;
  Quad<T>* product;

  SABO_HD void measure(std::size_t i, ResidualSums& sums) const {
    const Quad<T>& r = residual[i];
    const double inverse = 1 / static_cast<double>(diagonal[i]);
    const double per_mass = 1 / static_cast<double>(mass[i]);
    const double x = r.x, y = r.y, z = r.z;
    sums.join({(x * x + y * y + z * z) * inverse,
               (per_mass * per_mass) * Vec3d{x * x, y * y, z * z},
               {x, y, z}});
  }
};

/// From a change of zero along the preconditioned residual.
template <class T, class Residual>
struct StartSolve {
  SolverView<T> on;
  Residual residual_of;
  SABO_HD void operator()(std::size_t k, ResidualSums& sums) const {
    const std::size_t i = on.rows[k];
    const Quad<T> r = residual_of(i);
    on.residual[i] = r;
    const T inverse = T(1) / on.diagonal[i];
    on.change[i] = {};
    on.direction[i] = {inverse * r.x, inverse * r.y, inverse * r.z};
    on.measure(i, sums);
  }
};

/// a / b, and nothing of nothing.
template <class T>
SABO_HD T share_of(double a, double b) {
  return T(b > 0 ? a / b : 0);
}

/// How far a solve has come. It stays where the vectors are: no iteration waits for the host.
template <class T>
struct SolveProgress {
  double energy = 0;   ///< of the residual
  Vec3d residual_sum;  ///< over the rows, kg m/s
  T keep = 0;          ///< share of the last direction in the next one
  double enough = 0;   ///< of the residual, see ResidualSums
  int most = 0;        ///< iterations
  int iterations = 0;
  bool has_ended = false;
  bool has_converged = false;

  SABO_HD void take(const ResidualSums& sums) {
    energy = sums.energy;
    residual_sum = sums.residual;
    has_converged = !(sums.largest() > enough);
    has_ended = has_converged || iterations == most;
  }
};

/// What ends a solve. `tolerance()`, m/s, is asked for where the vectors are.
template <class Tolerance>
struct SolveLimits {
  Tolerance tolerance;  ///< of the residual over the mass, root mean square
  double rows = 0;      ///< over which it is taken
  double share = 0;     ///< of the first residual, see ResidualSums
  int most = 0;         ///< iterations
};

template <class T, class Tolerance>
struct BeginSolve {
  SolveLimits<Tolerance> limits;
  SolveProgress<T>* progress;
  SABO_HD void operator()(const ResidualSums& sums) const {
    const double tolerance = limits.tolerance();
    SolveProgress<T> begun;
    begun.enough = larger(tolerance * tolerance * limits.rows, limits.share * sums.largest());
    begun.most = limits.most;
    begun.take(sums);
    *progress = begun;
  }
};

/// Along the direction, as far as it takes the energy down.
template <class T>
struct AdvanceSolve {
  SolverView<T> on;
  const SolveProgress<T>* progress;
  const Total* curvature;
  SABO_HD void operator()(std::size_t k, ResidualSums& sums) const {
    if (progress->has_ended) return;
    const T length = share_of<T>(progress->energy, curvature->value);
    const std::size_t i = on.rows[k];
    const Quad<T>& p = on.direction[i];
    const Quad<T>& q = on.product[i];
    Quad<T>& x = on.change[i];
    Quad<T>& r = on.residual[i];
    x = {x.x + length * p.x, x.y + length * p.y, x.z + length * p.z};
    r = {r.x - length * q.x, r.y - length * q.y, r.z - length * q.z};
    on.measure(i, sums);
  }
};

/// Whether that is near enough.
template <class T>
struct JudgeSolve {
  SolveProgress<T>* progress;
  SABO_HD void operator()(const ResidualSums& sums) const {
    if (progress->has_ended) return;
    progress->keep = share_of<T>(sums.energy, progress->energy);
    ++progress->iterations;
    progress->take(sums);
  }
};

/// Into the next direction, which keeps a share of the last.
template <class T>
struct TurnSolve {
  SolverView<T> on;
  const SolveProgress<T>* progress;
  SABO_HD void operator()(std::size_t k) const {
    if (progress->has_ended) return;
    const T keep = progress->keep;
    const std::size_t i = on.rows[k];
    const T inverse = T(1) / on.diagonal[i];
    const Quad<T>& r = on.residual[i];
    Quad<T>& p = on.direction[i];
    p = {inverse * r.x + keep * p.x, inverse * r.y + keep * p.y, inverse * r.z + keep * p.z};
  }
};

/// Conjugate gradients with the diagonal as preconditioner (Hestenes & Stiefel 1952; Saad 2003,
/// algorithm 9.1) for a symmetric matrix of 3 x 3 blocks. Products are in the precision of T,
/// scalar products in double precision in a fixed order: the same bits for any number of threads.
template <class T, class Executor = HostExecutor>
class ViscousSolver {
 public:
  using Vector = typename Executor::template Array<Quad<T>>;

  // Rows of particles that take no part stay zero.
  Vector change;     ///< the solution, out
  Vector residual;   ///< kg m/s
  Vector direction;  ///< handed to the product
  Vector product;
  typename Executor::template Array<Total> curvature;  ///< one: direction . product
  typename Executor::template Array<T> diagonal;       ///< kg, in
  Vec3d residual_sum;       ///< over the rows, of the solution, out; kg m/s
  bool runs_ahead = false;  ///< whether iterations start before it is known that they are wanted

  void reset(const Executor& on, std::size_t particles) {
    for (Vector* v : {&change, &residual, &direction, &product}) on.zero(*v, particles);
    on.zero(diagonal, particles);
    on.zero(curvature, 1);
    on.zero(progress_, 1);
  }

  std::size_t bytes() const {
    return 4 * change.size() * sizeof(Quad<T>) + diagonal.size() * sizeof(T);
  }

  SolverView<T> view(RowList rows, const T* mass) {
    return {rows.index,       mass,          diagonal.data(), change.data(), residual.data(),
            direction.data(), product.data()};
  }

  /// Iterates until no component of the residual over the mass (kg) exceeds `tolerance()` (m/s,
  /// root mean square over `rows`), or what is left of the first one is rounding.
  /// `residual_of(i)` is that of a change of zero, kg m/s; of the vectors it may read `product`.
  /// `multiply(progress)` sets `product` to the matrix times `direction`, and `curvature`; it need
  /// not once progress->has_ended. One that runs ahead starts as many iterations as the last solve
  /// took and only then waits to hear of them, and then half as many again: those that are not
  /// wanted do nothing.
  template <class Residual, class Tolerance, class Multiply>
  ViscousSolve solve(const Executor& on, RowList rows, const T* mass, const Residual& residual_of,
                     const Tolerance& tolerance, int most, const Multiply& multiply) {
    const SolverView<T> vectors = view(rows, mass);
    SolveProgress<T>* progress = progress_.data();
    const SolveLimits<Tolerance> limits{tolerance, static_cast<double>(rows.count),
                                        least_share * least_share, most};
    on.template sum_up<ResidualSums>(rows.count, StartSolve<T, Residual>{vectors, residual_of},
                                     BeginSolve<T, Tolerance>{limits, progress});
    SolveProgress<T> known;
    for (int started = 0, ahead = runs_ahead ? iterations_ : 0;; ++started) {
      if (started >= ahead) {
        known = on.last(progress_);
        if (known.has_ended) break;
        ahead = started + (runs_ahead ? larger(2, started / 2) : 1);
      }
      if (started > 0) on.for_each(rows.count, TurnSolve<T>{vectors, progress});
      multiply(progress);
      on.template sum_up<ResidualSums>(rows.count,
                                       AdvanceSolve<T>{vectors, progress, curvature.data()},
                                       JudgeSolve<T>{progress});
    }
    iterations_ = known.iterations;
    residual_sum = known.residual_sum;
    return {known.iterations, known.has_converged};
  }

 private:
  /// Of the first residual: what the precision of the products leaves.
  static constexpr double least_share = 100 * std::numeric_limits<T>::epsilon();

  typename Executor::template Array<SolveProgress<T>> progress_;  // one
  int iterations_ = 0;                                            // of the last solve
};

}  // namespace sabo
