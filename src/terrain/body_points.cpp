#include "terrain/body_points.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "terrain/shell_points.hpp"

namespace sabo {
namespace {

constexpr double most_in_boxes = 5e7;  // particles
constexpr double most_in_shell = 5e6;  // while they are placed they take 1 kB each

void refuse_unless_fits(double count, double most, const Body& body) {
  if (count <= most) return;
  throw CaseError("body " + body.name(), "is too large for the particle spacing",
                  "check its size and unit (scale), or raise numerics.spacing");
}

/// A place along one side of a box, and the length it stands for.
struct Place {
  double at = 0;
  double width = 0;
};

/// From half a spacing behind one end to half a spacing before the other.
std::vector<Place> places_along(double length, double spacing) {
  if (length <= spacing) return {{length / 2, length}};
  const double between = length - spacing;
  const double steps = std::ceil(between / spacing - 1e-9);
  const double step = between / steps;
  std::vector<Place> places;
  for (int k = 0; k <= steps; ++k) {
    const bool is_end = k == 0 || k == steps;
    places.push_back({spacing / 2 + k * step, is_end ? (spacing + step) / 2 : step});
  }
  return places;
}

void fill_box(const UprightBox& box, const Body& body, double spacing, double density,
              std::vector<GroundPoint>& into) {
  const Vec3d size = box.size();
  const double shell = area(box_mesh(box)) * body.reach();
  refuse_unless_fits(std::min(size.x * size.y * size.z, shell) / std::pow(spacing, 3),
                     most_in_boxes, body);
  const double reach = body.reach();
  const auto is_deep = [reach](double at, double length) {
    return std::min(at, length - at) > reach;
  };
  const std::vector<Place> along_y = places_along(size.y, spacing);
  const std::vector<Place> along_z = places_along(size.z, spacing);
  std::vector<Place> ends_of_z = along_z;
  std::erase_if(ends_of_z, [&](const Place& z) { return is_deep(z.at, size.z); });
  for (const Place& x : places_along(size.x, spacing)) {
    for (const Place& y : along_y) {
      const bool is_core = is_deep(x.at, size.x) && is_deep(y.at, size.y);
      for (const Place& z : is_core ? ends_of_z : along_z) {
        into.push_back(
            {box.turned(box.low + Vec3d{x.at, y.at, z.at}), density * x.width * y.width * z.width});
      }
    }
  }
}

}  // namespace

std::vector<GroundPoint> body_points(const Body& body, double spacing, double density) {
  std::vector<GroundPoint> points;
  if (!body.boxes().empty()) {
    for (const UprightBox& box : body.boxes()) fill_box(box, body, spacing, density, points);
    return points;
  }
  const double shell = area(body.mesh()) * body.reach();
  refuse_unless_fits(shell / std::pow(spacing, 3), most_in_shell, body);
  points = shell_points(body, spacing, density);
  if (points.empty()) {
    throw CaseError("body " + body.name(), "is thinner than a third of the particle spacing",
                    "choose a smaller numerics.spacing");
  }
  return points;
}

}  // namespace sabo
