#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/host_device.hpp"
#include "physics/kernel.hpp"
#include "physics/plane_integral.hpp"

namespace sabo {

/// A kernel cut by a plane wall. The share S of the kernel that lies in the wall tells how far the
/// wall is, and its gradient where: sums over boundary particles give both for any shape of wall,
/// without normals. In three dimensions, with t = 1 - d/(2h), S = t^6 (7 - 9 t + 3 t^2) / 2.
///
/// A wall of particles is not full: it is layers at 1/2, 3/2, ... spacings behind its surface,
/// whose sum is the midpoint rule of S. At h/dp = 1.5 that takes a wall half a spacing away for one
/// 7 % farther, and friction for 7 % smaller; so distances are those of the layers.
class HalfSpace {
 public:
  HalfSpace(double h, int dimension, double spacing) : radius_(2 * h) {
    const auto kernel = WendlandC2<double>::make(h, dimension);
    for (int k = 0; k <= entries; ++k) {
      share_[k] = integral(kernel, dimension, place(k));
      const auto value = [&](double r) { return kernel.value(r); };
      for (double z = place(k) + 0.5 * spacing; z < radius_; z += spacing)
        layered_[k] += spacing * plane_integral(value, radius_, dimension, z);
    }
    steepest_ = slope(0) / (1 - share_[0]);
    for (int k = 0; k <= entries; ++k) completion_[k] = 1 / (1 - share(surface_distance(k)));
  }

  /// For a particle below a plane free surface, with nothing above it: the factor from the filled
  /// share of its kernel to what it would be without the surface, from the relative gradient of the
  /// filled share (1/m). Both shares grow alike where particles crowd, which leaves the gradient
  /// relative to the share to tell the distance to the surface. 1 inside, 2 at the surface.
  SABO_HD double completion(double relative_gradient) const {
    const double at = std::min(relative_gradient / steepest_, 1.0) * entries;
    const int k = std::min(static_cast<int>(at), entries - 1);
    return completion_[k] + (at - k) * (completion_[k + 1] - completion_[k]);
  }

  /// S at the distance d >= 0 (m): 1/2 at the wall, 0 from 2h on.
  SABO_HD double share(double d) const {
    const double at = std::min(d / radius_, 1.0) * entries;
    const int k = std::min(static_cast<int>(at), entries - 1);
    return share_[k] + (at - k) * (share_[k + 1] - share_[k]);
  }

  /// The distance at which the particles of a plane wall take the share S, m; 0 for those that
  /// belong to places within the wall.
  SABO_HD double distance(double share) const {
    if (share >= layered_.front()) return 0;
    if (!(layered_.back() < share)) return radius_;
    // By hand: in device code nvcc 13 loses the steps of std::upper_bound (std::advance of
    // libstdc++ 12 compiles to nothing), without a warning.
    int nearer = 0, k = entries;  // layered_[nearer] > share, layered_[k] < share
    while (k - nearer > 1) {
      const int middle = (nearer + k) / 2;
      (layered_[middle] < share ? k : nearer) = middle;
    }
    const double part = (layered_[k - 1] - share) / (layered_[k - 1] - layered_[k]);
    return place(k - 1) + part * (place(k) - place(k - 1));
  }

 private:
  static constexpr int entries = 128;

  /// |dS/dd| at the distance d, 1/m.
  double slope(double d) const {
    const double step = radius_ / entries;
    return (share(std::max(0.0, d - step)) - share(d + step)) / (std::min(d, step) + step);
  }

  /// Where a free surface gives the k-th relative gradient.
  double surface_distance(int k) const {
    double near = 0, far = radius_;
    for (int halvings = 0; halvings < 40; ++halvings) {
      const double d = 0.5 * (near + far);
      const bool is_steeper = slope(d) / (1 - share(d)) > steepest_ * k / entries;
      (is_steeper ? near : far) = d;
    }
    return far;
  }

  SABO_HD double place(int k) const { return radius_ * k / entries; }

  /// Over spheres (circles) of radius r around the particle, of which the wall cuts off a cap:
  /// int W 2 pi r (r - d) dr in three dimensions, int W 2 r acos(d/r) dr in two.
  double integral(const WendlandC2<double>& kernel, int dimension, double d) const {
    constexpr int steps = 2000;
    constexpr double pi = std::numbers::pi;
    const double dr = (radius_ - d) / steps;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
      const double r = d + (k + 0.5) * dr;
      const double cap = dimension == 2 ? 2 * r * std::acos(d / r) : 2 * pi * r * (r - d);
      sum += kernel.value(r) * cap * dr;
    }
    return sum;
  }

  double radius_;
  std::array<double, entries + 1> share_{};
  std::array<double, entries + 1> layered_{};  // shares of a wall of particles
  double steepest_ = 0;                        // relative gradient at a free surface, 1/m
  std::array<double, entries + 1> completion_{};
};

}  // namespace sabo
