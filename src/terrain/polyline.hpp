#pragma once

#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// Connected straight pieces in plan; z is carried along (0 when the source had none).
struct Polyline {
  std::vector<Vec3d> vertices;
  bool has_z = false;
};

/// Rings of one polygon: the first is the outer one, the others are holes. Rings need not repeat
/// their first vertex.
struct Polygon {
  std::vector<std::vector<Vec3d>> rings;
};

/// Nearest place on a polyline, in plan.
struct LinePlace {
  double station = 0;  ///< distance along the line from its first vertex, m
  double offset = 0;   ///< distance to the left of the line, m; negative to the right
};

inline Vec3d in_plan(const Vec3d& x) { return {x.x, x.y, 0}; }

/// Total length in plan, m.
double length(const Polyline& line);

/// Projects (x, y) on the line. Beyond its ends the first and last pieces are continued straight,
/// so the station may be negative or exceed the length.
LinePlace project(const Polyline& line, double x, double y);

/// Point at a station, z interpolated; the end pieces are continued straight.
Vec3d point_at(const Polyline& line, double station);

/// Unit vector along the line in plan; at a vertex that of the piece before it.
Vec3d direction_at(const Polyline& line, double station);

/// Even-odd rule over all rings; the outcome on an edge is unspecified.
bool contains(const Polygon& polygon, double x, double y);

/// Area in plan without the holes, m2.
double area(const Polygon& polygon);

}  // namespace sabo
