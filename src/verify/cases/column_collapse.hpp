#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "verify/energy_books.hpp"

#include "io/output/svg_chart.hpp"
#include "solver/lattice.hpp"
#include "solver/make_backend.hpp"
#include "solver/make_stepper.hpp"
#include "terrain/jitter.hpp"

namespace sabo {

/// A rectangular column in the plane, free on both sides, on a level bed.
struct ColumnShape {
  double half_width;  ///< L0, m
  double height;      ///< H0, m
  double reach;       ///< of the bed, from the middle of the column, m
};

/// The collapse of a column from the moment it is let go, when its density is that of its weight.
/// The whole of it: a plane of symmetry would be one more wall to get right.
class ColumnCollapse {
 public:
  /// The spacing of the model divides the sides of the column. With a seed particles are displaced
  /// at random by up to a twentieth of it: where a single outcome is a matter of chance, several
  /// are averaged.
  ColumnCollapse(const ColumnShape& shape, FlowModel model, const NumericsCase& numerics,
                 std::uint64_t seed = 0)
      : dp_(model.spacing), density_(model.state.rho0) {
    model.dimension = 2;
    backend_ = make_backend(numerics.backend, model);
    const int wide = cells(shape.half_width), high = cells(shape.height), bed = cells(shape.reach);
    add_block(backend_->fluid(), model, {-wide, wide, 0, 1, 0, high});
    add_block(backend_->boundary(), model, {-bed, bed, 0, 1, -model.wall_layers(), 0});
    make_hydrostatic(*backend_, shape.height);
    if (seed > 0) displace(shape.reach, seed);
    stepper_ = make_stepper(numerics, *backend_, nullptr);
    books_.emplace(*backend_);
  }

  void run_to(double time) { stepper_->advance_to(time); }

  const Particles& fluid() const { return backend_->fluid(); }
  /// See EnergyBooks.
  double energy_imbalance() const { return books_->imbalance(*backend_, *stepper_); }

  /// Volume over width between two distances from the middle, mean of both sides, m: the height.
  double height(double from, double to) const {
    double volume = 0;
    for (std::size_t i = 0; i < fluid().size(); ++i) {
      const double x = fluid().position[i].x;
      for (const double side : {x, -x}) {
        const double inside = std::min(to, side + dp_ / 2) - std::max(from, side - dp_ / 2);
        volume += std::max(0.0, inside) / dp_ * fluid().mass[i] / density_;
      }
    }
    return volume / (2 * (to - from));
  }

  /// Heights in bins of a width (m) up to a distance from the middle (m).
  ChartSeries profile(double reach, double bin) const {
    ChartSeries series;
    for (int k = 0; (k + 0.5) * bin < reach; ++k) {
      series.x.push_back((k + 0.5) * bin);
      series.y.push_back(height(k * bin, (k + 1) * bin));
    }
    return series;
  }

  /// Half the width of the mass, m. Four particles within seven spacings are a part of it; what is
  /// ahead of them is spray.
  double half_length() const {
    std::vector<double> x;
    for (const Vec3d& p : fluid().position) x.push_back(p.x);
    std::sort(x.begin(), x.end());
    std::size_t left = 0, right = x.size() - 1;
    while (x[left + 3] - x[left] > 7 * dp_) ++left;
    while (x[right] - x[right - 3] > 7 * dp_) --right;
    return (x[right] - x[left] + dp_) / 2;
  }

  /// Farthest distance from the middle at which bins of a width (m) are as high as `least` (m).
  double half_length_at(double least, double bin) const {
    const ChartSeries p = profile(half_length() + 2 * bin, bin);
    for (std::size_t k = p.x.size() - 1; k-- > 0;)
      if (p.y[k] >= least && p.y[k + 1] < least)
        return p.x[k] + bin * (p.y[k] - least) / (p.y[k] - p.y[k + 1]);
    return 0;
  }

 private:
  void displace(double reach, std::uint64_t seed) {
    const Surface level{Raster(Grid{2, 2, -2 * reach, 2 * reach, 2 * reach, 2 * reach})};
    jitter(backend_->fluid(), level, {0.05 * dp_, 0.25 * dp_, seed});
    for (Vec3d& p : backend_->fluid().position) p.y = 0;
  }

  int cells(double length) const { return static_cast<int>(std::lround(length / dp_)); }

  double dp_, density_;
  std::unique_ptr<Backend> backend_;
  std::unique_ptr<Stepper> stepper_;
  std::optional<EnergyBooks> books_;
};

}  // namespace sabo
