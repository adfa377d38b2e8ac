#pragma once

#include <span>

#include "math/vec3.hpp"

namespace sabo {

/// Where one looks, in degrees, as bearings are read from a map.
struct LookDirection {
  double azimuth = 0;  ///< clockwise from north, of the direction one looks towards
  double down = 35;    ///< below the horizon, 0 to 90
};

/// A point on a picture.
struct Projected {
  double x = 0;         ///< px from its left
  double y = 0;         ///< px from its top
  double distance = 0;  ///< m along the direction of view; only points with a positive one show
};

/// A pinhole camera whose horizon is level.
struct Camera {
  Vec3d place;
  Vec3d forward{0, 1, 0};  ///< unit vectors of the direction of view ...
  Vec3d right{1, 0, 0};
  Vec3d up{0, 0, 1};
  double focal = 1;     ///< px that 1 m takes at a distance of 1 m
  double centre_x = 0;  ///< px, where the direction of view meets the picture
  double centre_y = 0;

  Projected project(const Vec3d& point) const;
};

/// The nearest camera in that direction that holds all points with a margin of 5 % on each side, on
/// a picture of `width` x `height` px that opens 40 degrees from left to right. It keeps at least
/// `clearance` (m, > 0) in front of it. Points may be few or all the same, not none.
Camera camera_around(std::span<const Vec3d> points, const LookDirection& direction, double width,
                     double height, double clearance);

}  // namespace sabo
