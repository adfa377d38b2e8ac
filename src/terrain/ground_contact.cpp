#include <algorithm>
#include <cmath>
#include <vector>

#include "terrain/ground.hpp"

// The part of Ground that answers whether a point is in the solid and where it would be outside.

namespace sabo {
namespace {

constexpr double hair = 1e-3;  // spacings left between a point pushed out and the solid

bool is_below(const Surface& surface, const Vec3d& point) {
  return surface.inside(point.x, point.y) && point.z < surface.height(point.x, point.y);
}

}  // namespace

bool Ground::is_solid(const Vec3d& point) const {
  return is_below(surface_, point) || is_in_dam(point) || is_in_body(point);
}

bool Ground::is_in_dam(const Vec3d& point) const {
  return std::any_of(dams_.begin(), dams_.end(),
                     [&](const CheckDam& dam) { return dam.contains(point); });
}

bool Ground::is_in_body(const Vec3d& point) const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [&](const Body& body) { return body.contains(point); });
}

Vec3d Ground::pushed_out(const Vec3d& point) const {
  Vec3d moved = point;
  if (is_below(surface_, moved)) moved = out_of_ground(moved);
  for (const CheckDam& dam : dams_) {
    if (dam.contains(moved)) moved = out_of_dam(dam, moved);
  }
  const auto is_free = [this](const Vec3d& place) { return !is_solid(place); };
  for (const Body& body : bodies_) {
    if (!body.contains(moved)) continue;
    moved = body.way_out(moved, hair * settings_.spacing, is_free).value_or(lifted(moved));
  }
  return is_solid(moved) ? lifted(moved) : moved;
}

Vec3d Ground::out_of_ground(const Vec3d& point) const {
  const double depth = surface_.height(point.x, point.y) - point.z;
  // A search this wide is enough for any particle that is not already far astray.
  const double reach = std::min(depth, 10 * settings_.spacing);
  const auto found = surface_.nearest(point, reach);
  return found ? found->point + hair * settings_.spacing * found->normal : lifted(point);
}

/// Through the nearest of the top, the two faces, the two ends and the sides of its openings that
/// leads out of the solid.
Vec3d Ground::out_of_dam(const CheckDam& dam, const Vec3d& point) const {
  const double gap = hair * settings_.spacing;
  const double end = length(dam.axis);
  const LinePlace place = project(dam.axis, point.x, point.y);
  const auto at = [&](double station, double offset) {
    const Vec3d foot = point_at(dam.axis, station);
    const Vec3d along = direction_at(dam.axis, station);
    return Vec3d{foot.x - offset * along.y, foot.y + offset * along.x, point.z};
  };
  const auto at_height = [&](double z) { return Vec3d{point.x, point.y, z}; };
  const double face = dam.thickness / 2 + gap;
  std::vector<Vec3d> ways{at(place.station, face), at(place.station, -face), at(-gap, place.offset),
                          at(end + gap, place.offset), at_height(dam.top(place.station) + gap)};
  for (const Opening& opening : dam.openings) {
    ways.insert(ways.end(),
                {at(opening.from + gap, place.offset), at(opening.to - gap, place.offset)});
    const double side = opening.core / 2 + gap;
    if (opening.core > 0)
      ways.insert(ways.end(), {at(place.station, side), at(place.station, -side)});
    for (const double z : {opening.bottom + gap, opening.top - gap})
      if (std::isfinite(z)) ways.push_back(at_height(z));
  }
  std::stable_sort(ways.begin(), ways.end(), [&](const Vec3d& a, const Vec3d& b) {
    return norm(a - point) < norm(b - point);
  });
  const auto way =
      std::find_if(ways.begin(), ways.end(), [&](const Vec3d& p) { return !is_solid(p); });
  return way == ways.end() ? lifted(point) : *way;
}

/// Straight up until above everything.
Vec3d Ground::lifted(Vec3d point) const {
  const double gap = hair * settings_.spacing;
  point.z = std::max(point.z, surface_.height(point.x, point.y) + gap);
  for (const CheckDam& dam : dams_) {
    if (!dam.contains(point)) continue;
    point.z = dam.top(project(dam.axis, point.x, point.y).station) + gap;
  }
  for (const Body& body : bodies_) {
    if (body.contains(point)) point.z = body.bounds().high.z + gap;
  }
  return point;
}

}  // namespace sabo
