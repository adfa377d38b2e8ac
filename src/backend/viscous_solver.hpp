#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "math/quad.hpp"

namespace sabo {

/// How an implicit step of viscosity went.
struct ViscousSolve {
  int iterations = 0;
  bool converged = true;
  double heat = 0;  ///< kinetic energy that viscosity and walls took, J
};

/// Conjugate gradients with the diagonal as preconditioner (Hestenes & Stiefel 1952; Saad 2003,
/// algorithm 9.1) for the three components of one symmetric matrix at once. Products are in the
/// precision of T, scalar products in double precision over fixed blocks: the same bits for any
/// number of threads.
template <class T>
class ViscousSolver {
 public:
  using Vector = std::vector<Quad<T>>;
  using Dot = std::array<double, 3>;

  // Rows of particles that take no part stay zero.
  Vector change;     ///< the solution, out
  Vector residual;   ///< of a change of zero, in; kg m/s
  Vector direction;  ///< handed to the product
  Vector product;
  std::vector<T> diagonal;  ///< kg, in
  Dot residual_sum{};       ///< over the rows, of the solution, out; kg m/s

  void reset(std::size_t particles) {
    for (Vector* v : {&change, &residual, &direction, &product}) v->assign(particles, {});
    diagonal.assign(particles, T(1));
  }

  /// Iterates until no component of the residual over the mass exceeds `tolerance` (m/s, root mean
  /// square over `rows`), or what is left of the first one is rounding. `multiply` sets `product`
  /// to the matrix times `direction` and returns their scalar product.
  template <class Multiply>
  ViscousSolve solve(const std::vector<std::uint32_t>& rows, const std::vector<T>& mass,
                     double tolerance, int most, int threads, const Multiply& multiply) {
    mass_ = &mass;
    ViscousSolve outcome;
    Sums sums = restart(rows, threads);
    const double enough = std::max(tolerance * tolerance * static_cast<double>(rows.size()),
                                   least_share * least_share * sums.largest());
    residual_sum = sums.residual;
    while (sums.largest() > enough) {
      if (outcome.iterations == most) {
        outcome.converged = false;
        return outcome;
      }
      const Dot curvature = multiply();
      Dot length{};
      for (int c = 0; c < 3; ++c) length[c] = curvature[c] > 0 ? sums.energy[c] / curvature[c] : 0;
      const Sums next = advance(rows, length, threads);
      Dot keep{};
      for (int c = 0; c < 3; ++c)
        keep[c] = sums.energy[c] > 0 ? next.energy[c] / sums.energy[c] : 0;
      turn(rows, keep, threads);
      sums = next;
      residual_sum = sums.residual;
      ++outcome.iterations;
    }
    return outcome;
  }

 private:
  static constexpr std::size_t block = 1024;
  /// Of the first residual: what the precision of the products leaves.
  static constexpr double least_share = 100 * std::numeric_limits<T>::epsilon();

  struct Sums {
    Dot energy{};  ///< residual . residual / diagonal
    Dot size{};    ///< |residual / mass|^2
    Dot residual{};
    double largest() const { return std::max({size[0], size[1], size[2]}); }
  };

  /// f(particle, sums) over the rows by blocks, summed in their order.
  template <class F>
  Sums over(const std::vector<std::uint32_t>& rows, int threads, const F& f) {
    const auto blocks = static_cast<std::ptrdiff_t>((rows.size() + block - 1) / block);
    partial_.assign(static_cast<std::size_t>(blocks), {});
#pragma omp parallel for num_threads(threads) if (blocks > 3) schedule(static)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      const std::size_t last = std::min(rows.size(), (b + 1) * block);
      Sums sums;
      for (std::size_t k = b * block; k < last; ++k) f(rows[k], sums);
      partial_[b] = sums;
    }
    Sums total;
    for (const Sums& sums : partial_) {
      for (int c = 0; c < 3; ++c) {
        total.energy[c] += sums.energy[c];
        total.size[c] += sums.size[c];
        total.residual[c] += sums.residual[c];
      }
    }
    return total;
  }

  void measure(std::size_t i, Sums& sums) const {
    const Quad<T>& r = residual[i];
    const double inverse = 1 / static_cast<double>(diagonal[i]);
    const double per_mass = 1 / static_cast<double>((*mass_)[i]);
    const Dot component{static_cast<double>(r.x), static_cast<double>(r.y),
                        static_cast<double>(r.z)};
    for (int c = 0; c < 3; ++c) {
      sums.energy[c] += component[c] * component[c] * inverse;
      sums.size[c] += component[c] * component[c] * per_mass * per_mass;
      sums.residual[c] += component[c];
    }
  }

  Sums restart(const std::vector<std::uint32_t>& rows, int threads) {
    return over(rows, threads, [this](std::size_t i, Sums& sums) {
      const Quad<T>& r = residual[i];
      const T inverse = T(1) / diagonal[i];
      change[i] = {};
      direction[i] = {inverse * r.x, inverse * r.y, inverse * r.z};
      measure(i, sums);
    });
  }

  Sums advance(const std::vector<std::uint32_t>& rows, const Dot& length, int threads) {
    const T a = T(length[0]), b = T(length[1]), c = T(length[2]);
    return over(rows, threads, [&](std::size_t i, Sums& sums) {
      const Quad<T>& p = direction[i];
      const Quad<T>& q = product[i];
      Quad<T>& x = change[i];
      Quad<T>& r = residual[i];
      x = {x.x + a * p.x, x.y + b * p.y, x.z + c * p.z};
      r = {r.x - a * q.x, r.y - b * q.y, r.z - c * q.z};
      measure(i, sums);
    });
  }

  void turn(const std::vector<std::uint32_t>& rows, const Dot& keep, int threads) {
    const T a = T(keep[0]), b = T(keep[1]), c = T(keep[2]);
    over(rows, threads, [&](std::size_t i, Sums&) {
      const T inverse = T(1) / diagonal[i];
      const Quad<T>& r = residual[i];
      Quad<T>& p = direction[i];
      p = {inverse * r.x + a * p.x, inverse * r.y + b * p.y, inverse * r.z + c * p.z};
    });
  }

  const std::vector<T>* mass_ = nullptr;
  std::vector<Sums> partial_;
};

}  // namespace sabo
