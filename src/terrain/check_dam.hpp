#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

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

/// A rectangle of the face of a dam that is left open, through all of its thickness or beside a
/// core.
struct Opening {
  double from = 0;                                           ///< station along the dam line, m
  double to = 0;                                             ///< m
  double bottom = -std::numeric_limits<double>::infinity();  ///< elevation, m; from the ground
  double top = std::numeric_limits<double>::infinity();      ///< elevation, m; up to the crest
  double core = 0;  ///< thickness that stays about the axis, m, as of posts thinner than the dam

  /// Whether it is open at this distance from the axis (m).
  bool reaches(double offset) const { return std::abs(offset) >= core / 2; }
};

/// A wall of constant thickness along a line, from the ground up to its crest.
struct CheckDam {
  std::string name;
  Polyline axis;         ///< solver frame; z is the crest elevation where axis.has_z
  double crest = 0;      ///< crest elevation, m, where the axis has no z and there is no profile
  double thickness = 0;  ///< m
  std::optional<Notch> notch = {};
  std::vector<Opening> openings = {};
  std::vector<double> profile = {};  ///< crest elevations, evenly spaced from end to end, m

  /// Elevation of the crest at a station, m.
  double crest_at(double station) const;

  /// The same, the notch taken off; openings are not.
  double top(double station) const;

  /// Depth of the notch below the crest at a station, m; 0 beside it.
  double notch_depth(double station) const;

  /// Whether a point above the ground lies inside the wall.
  bool contains(const Vec3d& point) const;
};

/// An upright stretch of a dam.
struct DamPart {
  double bottom = 0;  ///< elevation, m
  double top = 0;     ///< elevation, m
};

/// What of the wall is solid above a point in plan, from `ground` (elevation, m) upwards; empty in
/// an opening.
std::vector<DamPart> solid_parts(const CheckDam& dam, double station, double offset, double ground);

/// Stations between which line, top and openings of a dam do not change, from end to end.
std::vector<double> dam_stations(const CheckDam& dam);

/// Distances from the axis between which the openings at a station do not change, from one face to
/// the other, m.
std::vector<double> dam_offsets(const CheckDam& dam, double station);

}  // namespace sabo
