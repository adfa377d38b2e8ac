#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace sabo {

/// An infinite slab of a Cross fluid with friction on an incline, from rest, in one dimension: its
/// pressure is its weight, its speed depends on time and height alone. Finite volumes, backward
/// Euler, the viscosity iterated within the step.
struct SlabSolution {
  double slope;           ///< rad
  double friction_angle;  ///< rad
  double depth = 3.75;    ///< m, normal to the bed
  double density = 1726;
  double viscosity = 1255;  ///< mu_B, Pa s
  double ratio = 1000;      ///< mu_0 over mu_B
  int cells = 200;
  double dt = 2e-3;

  /// Mean speed at the time t, m/s.
  double mean_speed(double t) const {
    std::vector<double> u(cells, 0.0);
    for (int step = 0; step < std::lround(t / dt); ++step) advance(u);
    double sum = 0;
    for (const double speed : u) sum += speed / cells;
    return sum;
  }

 private:
  static constexpr double g = 9.81;

  /// dt mu / (rho dz^2) at the lower face of each cell; the bed is half a cell below the first.
  std::vector<double> coupling(const std::vector<double>& u) const {
    const double dz = depth / cells;
    std::vector<double> result(cells);
    for (int i = 0; i < cells; ++i) {
      const double rate = std::abs(i ? (u[i] - u[i - 1]) / dz : u[0] / (dz / 2));
      const double yield =
          density * g * std::cos(slope) * (depth - i * dz) * std::tan(friction_angle);
      // Cross with m = 1: (mu_0 + K rate mu_B) / (1 + K rate), K = mu_0 / yield.
      const double mu_0 = ratio * viscosity;
      const double cross = (mu_0 * yield + mu_0 * rate * viscosity) / (yield + mu_0 * rate);
      result[i] = dt * cross / (density * dz * dz) * (i ? 1 : 2);
    }
    return result;
  }

  void advance(std::vector<double>& u) const {
    std::vector<double> guess = u, next(cells), d(cells), r(cells);
    for (int iteration = 0; iteration < 60; ++iteration) {
      const std::vector<double> c = coupling(guess);
      for (int i = 0; i < cells; ++i) {  // tridiagonal elimination
        d[i] = 1 + c[i] + (i + 1 < cells ? c[i + 1] : 0);
        r[i] = u[i] + dt * g * std::sin(slope);
        if (i == 0) continue;
        d[i] -= c[i] * c[i] / d[i - 1];
        r[i] += c[i] / d[i - 1] * r[i - 1];
      }
      double change = 0;
      for (int i = cells - 1; i >= 0; --i) {
        next[i] = (r[i] + (i + 1 < cells ? c[i + 1] * next[i + 1] : 0)) / d[i];
        change = std::max(change, std::abs(next[i] - guess[i]));
      }
      guess = next;
      if (change < 1e-8) break;
    }
    u = guess;
  }
};

}  // namespace sabo
