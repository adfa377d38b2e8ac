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
    double width = 0;   ///< that the flow covers, across the force, m; 0 where it is not felt

    /// Mean horizontal pressure, Pa.
    double pressure() const;
  };

  /// `base` is the elevation of the lowest bin's bottom, `radius` that of the kernel; m.
  LoadProfile(double base, double spacing, double radius);

  /// What acts at one place of the structure, N s. What lies below the base is given to the lowest
  /// bin.
  void add(const Vec3d& place, const Vec3d& impulse);

  /// A place of the structure at the moment of take(), and whether it feels the flow.
  void see(const Vec3d& place, bool feels_flow);

  /// The bins with their means over `interval` (s), from the lowest to the highest that was
  /// touched; starts anew.
  std::vector<Bin> take(double interval);

  template <class Archive>
  void archive(Archive& a) {
    a(impulse_);  // places are gone after take()
  }

 private:
  std::size_t bin_at(double elevation) const;
  double covered(std::size_t bin, const Vec3d& along) const;

  double base_, spacing_;
  double overhang_;                                // m, by which the kernel reaches beside the flow
  std::vector<Vec3d> impulse_;                     // by bin
  std::vector<std::vector<Vec3d>> felt_, unfelt_;  // by bin: places that do or do not
};

}  // namespace sabo
