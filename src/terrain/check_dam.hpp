#pragma once

#include <optional>
#include <string>

#include "math/vec3.hpp"
#include "terrain/polyline.hpp"

namespace sabo {

/// Spillway cut into the crest. Trapezoid: `side_slope` is the horizontal run for 1 m of rise.
struct Notch {
  double centre = 0;  ///< station along the dam line, m
  double width = 0;   ///< at its sill, m
  double depth = 0;   ///< of the sill below the crest, m
  double side_slope = 0;
};

/// A wall of constant thickness along a line, from the ground up to its crest.
struct CheckDam {
  std::string name;
  Polyline axis;         ///< solver frame; z is the crest elevation where axis.has_z
  double crest = 0;      ///< crest elevation, m, where the axis has no z
  double thickness = 0;  ///< m
  std::optional<Notch> notch;

  /// Elevation of the top at a station, the notch taken off, m.
  double top(double station) const;

  /// Depth of the notch below the crest at a station, m; 0 beside it.
  double notch_depth(double station) const;

  /// Whether a point above the ground lies inside the wall.
  bool contains(const Vec3d& point) const;
};

}  // namespace sabo
