#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "physics/kernel.hpp"
#include "physics/pair/forces.hpp"
#include "physics/pair/strain_rate.hpp"
#include "physics/rheology_list.hpp"

namespace sabo {

/// A flow between two plates, driven by a body force, as the sums of the solver make it of rows of
/// particles that lie still on a square lattice: in one dimension, by backward Euler, with the
/// viscosity of the last step. Beyond the plates the rows are mirrored and move the other way. What
/// a simulation misses as these rows do is no matter of motion, disorder, shifting or steps.
struct StillRows {
  Rheology law;
  double yield_stress;  ///< Pa
  double density;       ///< kg/m3
  double height;        ///< between the plates, m
  double drive;         ///< m/s2
  double h_over_dp;

  /// Speeds of the rows after `time` (s) from those of `speeds`, one a row from plate to plate,
  /// m/s.
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
    const double dp = height / count, volume = dp * dp;
    const auto kernel = WendlandC2<double>::make(h_over_dp * dp, 2);
    const int reach = static_cast<int>(std::ceil(kernel.radius() / dp)) - 1;
    Sums sums{std::vector(reach + 1, 0.0), std::vector(reach + 1, 0.0)};
    for (int row = 1; row <= reach; ++row)
      for (int k = -reach; k <= reach; ++k) {
        const auto pair = pair_geometry(Vec3d{k * dp, 0, row * dp}, kernel);
        sums.diffusion[row] += viscous_conductance(pair, 1.0, volume, volume) / (density * volume);
        sums.slope[row] += strain_rate(pair, Vec3d{1, 0, 0}, volume).xz;
      }
    return sums;
  }

  /// Row `k` or the one that it mirrors, and which way that moves.
  struct Image {
    int row;
    double sign;
  };
  static Image image(int k, int count) {
    if (k < 0) return {-1 - k, -1};
    if (k >= count) return {2 * count - 1 - k, -1};
    return {k, 1};
  }

  std::vector<double> viscosities(const std::vector<double>& u, const Sums& sums) const {
    const int count = static_cast<int>(u.size());
    std::vector<double> result(u.size());
    for (int i = 0; i < count; ++i) {
      double rate = 0;
      for (int away = 1; away <= sums.reach(); ++away) {
        const Image up = image(i + away, count), down = image(i - away, count);
        rate += sums.slope[away] * (up.sign * u[up.row] - down.sign * u[down.row]);
      }
      const Shear at{std::abs(rate), yield_stress, 0};
      result[i] = std::visit([&](const auto& l) { return l.viscosity(at); }, law);
    }
    return result;
  }

  void advance(std::vector<double>& u, const Sums& sums) const {
    const int count = static_cast<int>(u.size()), reach = sums.reach();
    const std::vector<double> mu = viscosities(u, sums);
    // Each line begins at the column i - reach.
    std::vector<std::vector<double>> lines(count, std::vector<double>(2 * reach + 1, 0.0));
    for (int i = 0; i < count; ++i) {
      u[i] += dt * drive;
      lines[i][reach] += 1;
      for (int j = i - reach; j <= i + reach; ++j) {
        if (j == i) continue;
        const auto [row, sign] = image(j, count);
        const double coupling =
            dt * pair_viscosity(mu[i], mu[row]) * sums.diffusion[std::abs(j - i)];
        lines[i][reach] += coupling;
        lines[i][row - i + reach] -= sign * coupling;
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
