#pragma once

#include <cstddef>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// How the force on a structure is spread over its height. Bins are as high as a spacing: each
/// holds what acts at the boundary particles in it, so that together they are the whole force.
class LoadProfile {
 public:
  struct Bin {
    double bottom = 0;  ///< elevation, m
    double top = 0;     ///< elevation, m
    Vec3d force;        ///< mean since the last take(), N
    double width = 0;   ///< of what is touched, across the force, m; 0 where nothing is

    /// Mean horizontal pressure, Pa.
    double pressure() const;
  };

  /// `base` is the elevation of the lowest bin's bottom; m.
  LoadProfile(double base, double spacing) : base_(base), spacing_(spacing) {}

  /// What acts at one place of the structure, N s. What lies below the base is given to the lowest
  /// bin.
  void add(const Vec3d& place, const Vec3d& impulse);

  /// A place of the structure that is touched at the moment of take().
  void touch(const Vec3d& place);

  /// The bins with their means over `interval` (s), from the lowest to the highest that was
  /// touched; starts anew.
  std::vector<Bin> take(double interval);

  template <class Archive>
  void archive(Archive& a) {
    a(impulse_, touched_);
  }

 private:
  std::size_t bin_at(double elevation) const;
  /// Length covered by places, each as long as a spacing, along a horizontal unit vector, m.
  double covered(const std::vector<Vec3d>& places, const Vec3d& along) const;

  double base_, spacing_;
  std::vector<Vec3d> impulse_;               // by bin
  std::vector<std::vector<Vec3d>> touched_;  // by bin
};

}  // namespace sabo
