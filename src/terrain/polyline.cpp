#include "terrain/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

double length_in_plan(const Vec3d& v) { return std::hypot(v.x, v.y); }

/// One straight piece of a line; pieces of no length are left out.
struct Piece {
  Vec3d from;
  Vec3d to;
  double start = 0;  ///< station of `from`
  double length = 0;
  bool is_first = false;
  bool is_last = false;
};

template <class Visit>
void for_each_piece(const Polyline& line, Visit&& visit) {
  Piece piece;
  for (std::size_t k = 1; k < line.vertices.size(); ++k) {
    const double step = length_in_plan(line.vertices[k] - line.vertices[k - 1]);
    if (step == 0) continue;
    const Piece previous = piece;
    piece = {line.vertices[k - 1],
             line.vertices[k],
             previous.start + previous.length,
             step,
             previous.length == 0,
             false};
    if (previous.length > 0) visit(previous);
  }
  piece.is_last = true;
  if (piece.length > 0) visit(piece);
}

/// The piece that holds a station, the first or last one for stations beyond the ends.
Piece piece_at(const Polyline& line, double station) {
  Piece found;
  for_each_piece(line, [&](const Piece& piece) {
    if (piece.is_first || station > piece.start) found = piece;
  });
  return found;
}

double signed_area(const std::vector<Vec3d>& ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    // Relative to the first vertex, which keeps the digits far from the origin.
    const Vec3d a = ring[k] - ring[0];
    const Vec3d b = ring[(k + 1) % ring.size()] - ring[0];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

}  // namespace

double length(const Polyline& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.vertices.size(); ++k) {
    sum += length_in_plan(line.vertices[k] - line.vertices[k - 1]);
  }
  return sum;
}

LinePlace project(const Polyline& line, double x, double y) {
  if (line.vertices.empty()) return {};
  const Vec3d point{x, y, 0};
  LinePlace best{0, length_in_plan(point - line.vertices[0])};
  double best_distance = std::numeric_limits<double>::infinity();
  double best_perpendicular = 0;
  for_each_piece(line, [&](const Piece& piece) {
    const Vec3d along = (1 / piece.length) * in_plan(piece.to - piece.from);
    const Vec3d from_start = in_plan(point - piece.from);
    double station = dot(from_start, along);
    if (!piece.is_first) station = std::max(station, 0.0);
    if (!piece.is_last) station = std::min(station, piece.length);
    const double distance = station == piece.length ? length_in_plan(point - piece.to)
                                                    : length_in_plan(from_start - station * along);
    const double perpendicular = cross(along, from_start).z;
    // Where two pieces share the nearest vertex, the larger perpendicular has the right side even
    // at bends sharper than 90 degrees.
    const bool is_nearer =
        distance < best_distance ||
        (distance == best_distance && std::abs(perpendicular) > std::abs(best_perpendicular));
    if (!is_nearer) return;
    best_distance = distance;
    best_perpendicular = perpendicular;
    best = {piece.start + station, std::copysign(distance, perpendicular)};
  });
  return best;
}

Vec3d point_at(const Polyline& line, double station) {
  const Piece piece = piece_at(line, station);
  if (piece.length == 0) return line.vertices.empty() ? Vec3d{} : line.vertices[0];
  return piece.from + ((station - piece.start) / piece.length) * (piece.to - piece.from);
}

Vec3d direction_at(const Polyline& line, double station) {
  const Piece piece = piece_at(line, station);
  if (piece.length == 0) return {1, 0, 0};
  return (1 / piece.length) * in_plan(piece.to - piece.from);
}

bool contains(const Polygon& polygon, double x, double y) {
  bool is_inside = false;
  for (const std::vector<Vec3d>& ring : polygon.rings) {
    for (std::size_t k = 0, previous = ring.size() - 1; k < ring.size(); previous = k++) {
      const Vec3d& a = ring[k];
      const Vec3d& b = ring[previous];
      if ((a.y > y) == (b.y > y)) continue;
      if (x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
  }
  return is_inside;
}

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.rings.size(); ++k) {
    const double ring = std::abs(signed_area(polygon.rings[k]));
    sum += k == 0 ? ring : -ring;
  }
  return sum;
}

}  // namespace sabo
