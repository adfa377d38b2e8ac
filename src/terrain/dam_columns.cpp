#include "terrain/dam_columns.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double most_dam_columns = 1e7;
constexpr double most_in_dam = 1e8;

void refuse_unless_fits(double count, double most, const std::string& place) {
  if (count <= most) return;
  throw CaseError(place, "the dam is too large for the particle spacing",
                  "check its line, thickness and crest, or raise numerics.spacing");
}

/// Number of parts no longer than `longest`.
double parts(double whole, double longest) { return std::ceil(whole / longest - 1e-9); }

/// The middle of a piece and its length, m.
struct Stretch {
  double at = 0;
  double length = 0;
};

/// Pieces of equal length, at most `longest` each and at least `fewest`.
std::vector<Stretch> stretches(double from, double to, double longest, double fewest) {
  const double count = std::max(fewest, parts(to - from, longest));
  const double step = (to - from) / count;
  std::vector<Stretch> result;
  for (int k = 0; k < count; ++k) result.push_back({from + (k + 0.5) * step, step});
  return result;
}

/// A place in plan and where it lies along and beside the axis.
struct Foot {
  double x, y;
  double station, offset;
};

void add_column(const CheckDam& dam, const Surface& surface, const Foot& foot, double area,
                std::vector<DamColumn>& columns) {
  if (!surface.inside(foot.x, foot.y)) return;
  const double ground = surface.height(foot.x, foot.y);
  for (const DamPart& part : solid_parts(dam, foot.station, foot.offset, ground))
    columns.push_back({foot.x, foot.y, part.bottom, part.top, area});
}

void add_straight(const CheckDam& dam, const Surface& surface, const Stretch& along,
                  const Stretch& aside, std::vector<DamColumn>& columns) {
  const Vec3d middle = point_at(dam.axis, along.at);
  const Vec3d direction = direction_at(dam.axis, along.at);
  const Foot foot{middle.x - aside.at * direction.y, middle.y + aside.at * direction.x, along.at,
                  aside.at};
  // In a bend the pieces of the line overlap on its inner side, where the nearest one has a place;
  // the earlier one if they are equally near.
  const Vec3d back = 1e-6 * dam.thickness * direction;
  const double nearest = project(dam.axis, foot.x - back.x, foot.y - back.y).station;
  if (std::abs(nearest - along.at) > 1e-5 * dam.thickness) return;
  add_column(dam, surface, foot, along.length * aside.length, columns);
}

/// The sector of a circle by which the pieces of the line part on the outer side of a bend.
void add_bend(const CheckDam& dam, const Surface& surface, double station, double spacing,
              std::vector<DamColumn>& columns) {
  const double hair = 1e-6 * dam.thickness;
  const Vec3d vertex = point_at(dam.axis, station);
  const Vec3d before = direction_at(dam.axis, station - hair);
  const Vec3d after = direction_at(dam.axis, station + hair);
  const double turn =
      std::atan2(before.x * after.y - before.y * after.x, before.x * after.x + before.y * after.y);
  if (std::abs(turn) < 1e-6) return;
  const double side = turn > 0 ? -1 : 1;  // left of the line is positive
  const double first = std::atan2(side * before.x, -side * before.y);
  for (const Stretch& radius : stretches(0, dam.thickness / 2, spacing, 1)) {
    const double count = std::max(1.0, parts(radius.at * std::abs(turn), spacing));
    const double area = radius.length * radius.at * std::abs(turn) / count;
    for (int k = 0; k < count; ++k) {
      const double angle = first + turn * (k + 0.5) / count;
      add_column(dam, surface,
                 {vertex.x + radius.at * std::cos(angle), vertex.y + radius.at * std::sin(angle),
                  station, side * radius.at},
                 area, columns);
    }
  }
}

void add_bends(const CheckDam& dam, const Surface& surface, double spacing,
               std::vector<DamColumn>& columns) {
  double station = 0;
  const std::vector<Vec3d>& vertices = dam.axis.vertices;
  for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
    station += std::hypot(vertices[k].x - vertices[k - 1].x, vertices[k].y - vertices[k - 1].y);
    add_bend(dam, surface, station, spacing, columns);
  }
}

}  // namespace

std::vector<DamColumn> dam_columns(const CheckDam& dam, const Surface& surface, double spacing) {
  const std::string place = "structure " + dam.name;
  refuse_unless_fits(parts(dam.thickness, spacing) * parts(length(dam.axis), spacing),
                     most_dam_columns, place);
  std::vector<DamColumn> columns;
  const std::vector<double> stations = dam_stations(dam);
  for (std::size_t k = 1; k < stations.size(); ++k) {
    const double middle = (stations[k - 1] + stations[k]) / 2;
    const std::vector<double> offsets = dam_offsets(dam, middle);
    // The wall, or what stays of it between openings, is a plate: it has a row under each face.
    const std::size_t core = (offsets.size() - 1) / 2;
    for (std::size_t j = 1; j < offsets.size(); ++j) {
      const std::vector<Stretch> across =
          stretches(offsets[j - 1], offsets[j], spacing, j - 1 == core ? 2 : 1);
      for (const Stretch& along : stretches(stations[k - 1], stations[k], spacing, 1))
        for (const Stretch& aside : across) add_straight(dam, surface, along, aside, columns);
    }
  }
  add_bends(dam, surface, spacing, columns);
  double particles = 0;
  for (const DamColumn& column : columns) particles += (column.top - column.bottom) / spacing;
  refuse_unless_fits(particles, most_in_dam, place);
  if (columns.empty()) {
    throw CaseError(place, "no part of the dam stands above the ground inside the DEM",
                    "check its line, its crest and its openings");
  }
  return columns;
}

void fill_column(const DamColumn& column, const GroundSettings& settings,
                 std::vector<GroundPoint>& into) {
  const double height = column.top - column.bottom;
  const double count = std::max(1.0, parts(height, settings.spacing));
  const double step = height / count;
  const double mass = settings.density * column.area * step;
  for (int k = 0; k < count; ++k) {
    into.push_back({{column.x, column.y, column.bottom + (k + 0.5) * step}, mass, column.body});
  }
}

}  // namespace sabo
