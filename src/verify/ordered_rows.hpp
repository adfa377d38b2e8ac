#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "physics/layered_viscosity.hpp"
#include "physics/pair/forces.hpp"
#include "physics/rheology_list.hpp"

namespace sabo {

/// A flow between two plates, driven by a body force, as the sums of the solver make it of rows of
/// particles that slide over each other in order: in one dimension, since such rows meet at all
/// places along them. By backward Euler, with the viscosity of the last step. What a simulation
/// misses as these rows do is no matter of disorder, shifting, walls or steps.
struct OrderedRows {
  Rheology law;
  double yield_stress;  ///< Pa
  double density;       ///< kg/m3
  double height;        ///< between the plates, m
  double drive;         ///< m/s2
  double h_over_dp;

  /// Speeds of the rows after `time` (s) from those of `speeds`, one a row from plate to plate,
  /// m/s. Rows whose kernel reaches beyond a plate keep theirs.
  std::vector<double> after(double time, std::vector<double> speeds) const {
    const Sums sums = sums_over_rows(static_cast<int>(speeds.size()));
    for (int step = 0; step < std::lround(time / dt); ++step) advance(speeds, sums);
    return speeds;
  }

 private:
  static constexpr double dt = 2e-3;  // s

  /// Of one particle with the rows that are 1, 2, ... rows away from it.
  struct Sums {
    std::vector<double> diffusion;  ///< conductances over the viscosity and the mass, m/kg
    std::vector<double> slope;      ///< shear rate over the difference of speed, 1/m
    int reach() const { return static_cast<int>(slope.size()) - 1; }
  };

  Sums sums_over_rows(int count) const {
    const double dp = height / count;
    const auto kernel = WendlandC2<double>::make(h_over_dp * dp, 2);
    const double carried = layered_viscosity(kernel, 2, dp);  // see there: both are divided by it
    Sums sums{{0}, {0}};
    for (double z = dp; z < kernel.radius(); z += dp) {
      const auto steepness = [&](double r) { return -kernel.gradient_factor(r); };
      const double share = dp * plane_integral(steepness, kernel.radius(), 2, z) / carried;
      sums.diffusion.push_back(2 * share / density);
      sums.slope.push_back(share * z);
    }
    return sums;
  }

  std::vector<double> viscosities(const std::vector<double>& u, const Sums& sums) const {
    const int count = static_cast<int>(u.size());
    const auto speed = [&](int k) {  // beyond a plate it goes on as it comes
      return k < 0 ? -u[-1 - k] : k < count ? u[k] : -u[2 * count - 1 - k];
    };
    std::vector<double> result(u.size());
    for (int i = 0; i < count; ++i) {
      double rate = 0;
      for (int away = 1; away <= sums.reach(); ++away)
        rate += sums.slope[away] * (speed(i + away) - speed(i - away));
      const Shear at{std::abs(rate), yield_stress, 0};
      result[i] = std::visit([&](const auto& l) { return l.viscosity(at); }, law);
    }
    return result;
  }

  void advance(std::vector<double>& u, const Sums& sums) const {
    const int count = static_cast<int>(u.size()), reach = sums.reach();
    const std::vector<double> mu = viscosities(u, sums);
    // Each line of the matrix begins at the column i - reach.
    std::vector<std::vector<double>> lines(count, std::vector<double>(2 * reach + 1, 0.0));
    for (int i = 0; i < count; ++i) {
      lines[i][reach] = 1;
      if (i < reach || i >= count - reach) continue;
      u[i] += dt * drive;
      for (int j = i - reach; j <= i + reach; ++j) {
        if (j == i) continue;
        const double coupling = dt * pair_viscosity(mu[i], mu[j]) * sums.diffusion[std::abs(j - i)];
        lines[i][reach] += coupling;
        lines[i][j - i + reach] = -coupling;
      }
    }
    solve(lines, u, reach);
  }

  /// Elimination in a band.
  static void solve(std::vector<std::vector<double>>& lines, std::vector<double>& u, int reach) {
    const int count = static_cast<int>(u.size());
    for (int i = 0; i < count; ++i)
      for (int below = i + 1; below <= std::min(i + reach, count - 1); ++below) {
        const double share = lines[below][i - below + reach] / lines[i][reach];
        for (int column = i; column <= i + reach; ++column)
          lines[below][column - below + reach] -= share * lines[i][column - i + reach];
        u[below] -= share * u[i];
      }
    for (int i = count - 1; i >= 0; --i) {
      for (int column = i + 1; column <= std::min(i + reach, count - 1); ++column)
        u[i] -= lines[i][column - i + reach] * u[column];
      u[i] /= lines[i][reach];
    }
  }
};

}  // namespace sabo
