#include "terrain/dam_columns.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double most_columns = 1e7;
constexpr double most_particles = 1e8;

void refuse_unless_fits(double count, double most, const std::string& place) {
  if (count <= most) return;
  throw CaseError(place, "the dam is too large for the particle spacing",
                  "check its line, thickness and crest, or raise numerics.spacing");
}

/// Stations between which both the line and the top of the wall are straight.
std::vector<double> corners(const CheckDam& dam) {
  const double end = length(dam.axis);
  std::vector<double> stations{0, end};
  double station = 0;
  for (std::size_t k = 1; k < dam.axis.vertices.size(); ++k) {
    const Vec3d step = dam.axis.vertices[k] - dam.axis.vertices[k - 1];
    station += std::hypot(step.x, step.y);
    stations.push_back(station);
  }
  if (dam.notch) {
    const double half_sill = dam.notch->width / 2;
    const double half_crest = half_sill + dam.notch->side_slope * dam.notch->depth;
    for (const double half : {half_sill, half_crest}) {
      stations.push_back(dam.notch->centre - half);
      stations.push_back(dam.notch->centre + half);
    }
  }
  for (double& s : stations) s = std::clamp(s, 0.0, end);
  std::sort(stations.begin(), stations.end());
  // Corners closer than this are one corner with rounding errors.
  const double tolerance = 1e-9 * (1 + end);
  const auto same = [&](double a, double b) { return b - a < tolerance; };
  stations.erase(std::unique(stations.begin(), stations.end(), same), stations.end());
  return stations;
}

/// Number of parts no longer than `longest`.
double parts(double whole, double longest) { return std::ceil(whole / longest - 1e-9); }

}  // namespace

std::vector<DamColumn> dam_columns(const CheckDam& dam, const Surface& surface, double spacing) {
  const std::string place = "structure " + dam.name;
  const double across = std::max(2.0, parts(dam.thickness, spacing));
  refuse_unless_fits(across * parts(length(dam.axis), spacing), most_columns, place);
  const std::vector<double> stations = corners(dam);
  std::vector<DamColumn> columns;
  for (std::size_t k = 1; k < stations.size(); ++k) {
    const double along = std::max(1.0, parts(stations[k] - stations[k - 1], spacing));
    const double ds = (stations[k] - stations[k - 1]) / along;
    const double dn = dam.thickness / across;
    for (int i = 0; i < along; ++i) {
      const double station = stations[k - 1] + (i + 0.5) * ds;
      const Vec3d foot = point_at(dam.axis, station);
      const Vec3d direction = direction_at(dam.axis, station);
      const double top = dam.top(station);
      for (int j = 0; j < across; ++j) {
        const double offset = (j + 0.5) * dn - dam.thickness / 2;
        const double x = foot.x - offset * direction.y;
        const double y = foot.y + offset * direction.x;
        const double bottom = surface.height(x, y);
        if (surface.inside(x, y) && bottom < top) columns.push_back({x, y, bottom, top, ds * dn});
      }
    }
  }
  double particles = 0;
  for (const DamColumn& column : columns) particles += (column.top - column.bottom) / spacing;
  refuse_unless_fits(particles, most_particles, place);
  if (columns.empty()) {
    throw CaseError(place, "no part of the dam stands above the ground inside the DEM",
                    "check its line and its crest");
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
