#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "backend/flow_view.hpp"
#include "backend/host_executor.hpp"
#include "backend/viscous_solve.hpp"
#include "math/quad.hpp"

namespace sabo {

/// Three scalar products, one for each component.
struct Dot {
  double x = 0, y = 0, z = 0;
  SABO_HD void join(const Dot& other) {
    x += other.x;
    y += other.y;
    z += other.z;
  }
};

/// What an iteration wants to know of the residual.
struct ResidualSums {
  Dot energy;    ///< residual . residual / diagonal
  Dot size;      ///< |residual / mass|^2
  Dot residual;  ///< sum
  SABO_HD void join(const ResidualSums& other) {
    energy.join(other.energy);
    size.join(other.size);
    residual.join(other.residual);
  }
  double largest() const { return std::max({size.x, size.y, size.z}); }
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
    sums.join(
        {{x * x * inverse, y * y * inverse, z * z * inverse},
         {x * x * per_mass * per_mass, y * y * per_mass * per_mass, z * z * per_mass * per_mass},
         {x, y, z}});
  }
};

/// From a change of zero along the preconditioned residual.
template <class T>
struct StartSolve {
  SolverView<T> on;
  SABO_HD void operator()(std::size_t k, ResidualSums& sums) const {
    const std::size_t i = on.rows[k];
    const Quad<T>& r = on.residual[i];
    const T inverse = T(1) / on.diagonal[i];
    on.change[i] = {};
    on.direction[i] = {inverse * r.x, inverse * r.y, inverse * r.z};
    on.measure(i, sums);
  }
};

/// Component by component.
template <class T>
SABO_HD Vec3<T> ratios(const Dot& a, const Dot& b) {
  return {T(b.x > 0 ? a.x / b.x : 0), T(b.y > 0 ? a.y / b.y : 0), T(b.z > 0 ? a.z / b.z : 0)};
}

/// How far to go along the direction.
template <class T>
struct FindLength {
  Dot energy;
  const Dot* curvature;
  Vec3<T>* length;
  SABO_HD void operator()(std::size_t) const { *length = ratios<T>(energy, *curvature); }
};

/// As far as that.
template <class T>
struct AdvanceSolve {
  SolverView<T> on;
  const Vec3<T>* how_far;
  SABO_HD void operator()(std::size_t k, ResidualSums& sums) const {
    const Vec3<T> length = *how_far;
    const std::size_t i = on.rows[k];
    const Quad<T>& p = on.direction[i];
    const Quad<T>& q = on.product[i];
    Quad<T>& x = on.change[i];
    Quad<T>& r = on.residual[i];
    x = {x.x + length.x * p.x, x.y + length.y * p.y, x.z + length.z * p.z};
    r = {r.x - length.x * q.x, r.y - length.y * q.y, r.z - length.z * q.z};
    on.measure(i, sums);
  }
};

/// Into the next direction, which keeps a share of the last.
template <class T>
struct TurnSolve {
  SolverView<T> on;
  Vec3<T> keep;
  SABO_HD void operator()(std::size_t k) const {
    const std::size_t i = on.rows[k];
    const T inverse = T(1) / on.diagonal[i];
    const Quad<T>& r = on.residual[i];
    Quad<T>& p = on.direction[i];
    p = {inverse * r.x + keep.x * p.x, inverse * r.y + keep.y * p.y, inverse * r.z + keep.z * p.z};
  }
};

/// Conjugate gradients with the diagonal as preconditioner (Hestenes & Stiefel 1952; Saad 2003,
/// algorithm 9.1) for the three components of one symmetric matrix at once. Products are in the
/// precision of T, scalar products in double precision in a fixed order: the same bits for any
/// number of threads.
template <class T, class Executor = HostExecutor>
class ViscousSolver {
 public:
  using Vector = typename Executor::template Array<Quad<T>>;

  // Rows of particles that take no part stay zero.
  Vector change;     ///< the solution, out
  Vector residual;   ///< of a change of zero, in; kg m/s
  Vector direction;  ///< handed to the product
  Vector product;
  typename Executor::template Array<Dot> curvature;  ///< one: direction . product
  typename Executor::template Array<T> diagonal;     ///< kg, in
  Dot residual_sum;  ///< over the rows, of the solution, out; kg m/s

  void reset(const Executor& on, std::size_t particles) {
    for (Vector* v : {&change, &residual, &direction, &product}) on.zero(*v, particles);
    on.zero(diagonal, particles);
    on.zero(curvature, 1);
    on.zero(length_, 1);
  }

  std::size_t bytes() const {
    return 4 * change.size() * sizeof(Quad<T>) + diagonal.size() * sizeof(T);
  }

  SolverView<T> view(RowList rows, const T* mass) {
    return {rows.index,       mass,          diagonal.data(), change.data(), residual.data(),
            direction.data(), product.data()};
  }

  /// Iterates until no component of the residual over the mass (kg) exceeds `tolerance` (m/s, root
  /// mean square over `rows`), or what is left of the first one is rounding. `multiply` sets
  /// `product` to the matrix times `direction`, and `curvature`. The residual alone is waited for.
  template <class Multiply>
  ViscousSolve solve(const Executor& on, RowList rows, const T* mass, double tolerance, int most,
                     const Multiply& multiply) {
    const SolverView<T> vectors = view(rows, mass);
    ViscousSolve outcome;
    auto sums = on.template reduce<ResidualSums>(rows.count, StartSolve<T>{vectors});
    const double enough = std::max(tolerance * tolerance * static_cast<double>(rows.count),
                                   least_share * least_share * sums.largest());
    residual_sum = sums.residual;
    Dot former;  // energy of the residual before the last one
    while (sums.largest() > enough) {
      if (outcome.iterations == most) {
        outcome.converged = false;
        return outcome;
      }
      if (outcome.iterations > 0)
        on.for_each(rows.count, TurnSolve<T>{vectors, ratios<T>(sums.energy, former)});
      multiply();
      on.for_each(1, FindLength<T>{sums.energy, curvature.data(), length_.data()});
      former = sums.energy;
      sums = on.template reduce<ResidualSums>(rows.count, AdvanceSolve<T>{vectors, length_.data()});
      residual_sum = sums.residual;
      ++outcome.iterations;
    }
    return outcome;
  }

 private:
  /// Of the first residual: what the precision of the products leaves.
  static constexpr double least_share = 100 * std::numeric_limits<T>::epsilon();

  typename Executor::template Array<Vec3<T>> length_;  // one
};

}  // namespace sabo
