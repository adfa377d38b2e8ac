#include "io/output/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/angle.hpp"

namespace sabo {
namespace {

constexpr double half_opening = 20 * degree;
constexpr double share_used = 0.9;  // of the picture

// The lines of sight along two opposite edges of the picture, in the plane of the direction of view
// and one axis of the picture. A point (across, along) is between them for a camera at (c, d) when
//   |across - c| <= tangent (along - d),
// so the farthest forward camera follows from the two greatest differences alone.
struct Wedge {
  double tangent;
  double left = -std::numeric_limits<double>::infinity();  // greatest across - tangent along
  double right = std::numeric_limits<double>::infinity();  // smallest across + tangent along

  void hold(double across, double along) {
    left = std::max(left, across - tangent * along);
    right = std::min(right, across + tangent * along);
  }
  double along() const { return (right - left) / (2 * tangent); }
  double across() const { return (left + right) / 2; }
};

}  // namespace

Projected Camera::project(const Vec3d& point) const {
  const Vec3d d = point - place;
  const double distance = dot(forward, d);
  return {centre_x + focal * dot(right, d) / distance, centre_y - focal * dot(up, d) / distance,
          distance};
}

Camera camera_around(std::span<const Vec3d> points, const LookDirection& direction, double width,
                     double height, double clearance) {
  const double azimuth = direction.azimuth * degree;
  const double down = direction.down * degree;
  Camera camera;
  camera.right = {std::cos(azimuth), -std::sin(azimuth), 0};
  camera.forward = {std::sin(azimuth) * std::cos(down), std::cos(azimuth) * std::cos(down),
                    -std::sin(down)};
  camera.up = cross(camera.right, camera.forward);
  camera.focal = width / 2 / std::tan(half_opening);
  camera.centre_x = width / 2;
  camera.centre_y = height / 2;

  // Relative to one of them, which keeps the digits far from the origin.
  const Vec3d origin = points.front();
  Wedge sideways{share_used * width / 2 / camera.focal};
  Wedge upright{share_used * height / 2 / camera.focal};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3d& point : points) {
    const Vec3d d = point - origin;
    const double along = dot(camera.forward, d);
    sideways.hold(dot(camera.right, d), along);
    upright.hold(dot(camera.up, d), along);
    nearest = std::min(nearest, along);
  }
  const double along = std::min({sideways.along(), upright.along(), nearest - clearance});
  camera.place = origin + sideways.across() * camera.right + upright.across() * camera.up +
                 along * camera.forward;
  return camera;
}

}  // namespace sabo
