#include "terrain/valley.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/angle.hpp"

namespace sabo {
namespace {

constexpr double valley_length = 1200;

/// Slope of the bed at a place; between the knots it changes linearly.
struct Knot {
  double x;
  double slope;  // degrees
};
constexpr std::array<Knot, 8> knots{
    {{0, 33}, {60, 33}, {150, 24}, {300, 18}, {500, 14}, {650, 10}, {800, 6}, {1200, 4}}};

/// Fall of a bed whose slope angle goes linearly from `above` to `below` (degrees) over `run`: the
/// integral of the tangent of the angle.
double fall(double above, double below, double run) {
  if (above == below) return run * std::tan(above * degree);
  const double angle_per_metre = (below - above) * degree / run;
  return std::log(std::cos(above * degree) / std::cos(below * degree)) / angle_per_metre;
}

constexpr double fan_start = 650;  // x where the valley opens

double half_width_of_bed(double x) { return 6 + 0.12 * std::max(0.0, x - fan_start); }

/// Rise of the valley side at a distance from the edge of the bed, m.
double side_rise(double x, double distance) {
  const double steepness = x < fan_start ? 0.55 : 0.53 * std::exp(-(x - fan_start) / 60) + 0.02;
  return steepness * distance * distance / (distance + 8);
}

constexpr double source_top = 25;
constexpr double source_depth = 5;
constexpr double source_half_width = 14;
constexpr double source_volume = 8863;
// The cross-section of the source is a parabola.
constexpr double source_length = source_volume / (4.0 / 3.0 * source_depth * source_half_width);

}  // namespace

double valley_slope(double x) {
  if (x <= knots.front().x) return knots.front().slope;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (x > knots[k].x) continue;
    const double along = (x - knots[k - 1].x) / (knots[k].x - knots[k - 1].x);
    return knots[k - 1].slope + along * (knots[k].slope - knots[k - 1].slope);
  }
  return knots.back().slope;
}

double valley_bed(double x) {
  double z = 250;
  if (x < knots.front().x) return z - fall(knots.front().slope, knots.front().slope, x);
  for (std::size_t k = 1; k < knots.size() && x > knots[k - 1].x; ++k) {
    const double end = std::min(x, knots[k].x);
    z -= fall(knots[k - 1].slope, valley_slope(end), end - knots[k - 1].x);
  }
  const double beyond = std::max(0.0, x - knots.back().x);
  return z - fall(knots.back().slope, knots.back().slope, beyond);
}

double valley_axis(double x) {
  const double growth = std::clamp(x / 150, 0.0, 1.0);
  const double fading = x > 750 ? std::exp(-(x - 750) / 100) : 1;
  return 12 * std::sin(2 * std::numbers::pi * x / 420) * growth * fading;
}

double valley_elevation(double x, double y) {
  const double from_bed = std::abs(y - valley_axis(x)) - half_width_of_bed(x);
  return valley_bed(x) + side_rise(x, std::max(0.0, from_bed));
}

Raster valley_dem(double cell_size, double half_width) {
  Grid grid;
  // Whole cells about the centre line, with cell centres on all edges or beyond them.
  grid.dx = grid.dy = cell_size;
  grid.columns = static_cast<int>(std::ceil(valley_length / cell_size)) + 1;
  grid.rows = 2 * static_cast<int>(std::ceil(half_width / cell_size)) + 1;
  grid.west = -cell_size / 2;
  grid.north = grid.rows * cell_size / 2;
  Raster dem(grid);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      dem.at(column, row) = valley_elevation(grid.x_of(column), grid.y_of(row));
    }
  }
  return dem;
}

Polyline valley_path() {
  Polyline path{{}, true};
  for (double x = 0; x <= valley_length; x += 5) {
    path.vertices.push_back({x, valley_axis(x), valley_bed(x)});
  }
  return path;
}

ReleaseShape valley_release() {
  ReleaseShape shape;
  shape.thickness = [](double x, double y) {
    const double d = (y - valley_axis(x)) / source_half_width;
    const bool is_within = x >= source_top && x < source_top + source_length && std::abs(d) < 1;
    return is_within ? source_depth * (1 - d * d) : 0;
  };
  shape.west = source_top;
  shape.east = source_top + source_length;
  shape.south = -12 - source_half_width;  // 12: the widest swing of the axis
  shape.north = 12 + source_half_width;
  shape.volume = source_volume;
  shape.area = source_length * 2 * source_half_width;
  return shape;
}

CheckDam valley_dam() {
  constexpr double x = 620;
  constexpr double height = 8;
  CheckDam dam;
  dam.name = "dam";
  dam.crest = valley_bed(x) + height;
  dam.thickness = 3.2;

  const Vec3d centre{x, valley_axis(x), 0};
  const Vec3d along = normalised(Vec3d{1, (valley_axis(x + 0.5) - valley_axis(x - 0.5)), 0});
  const Vec3d left{-along.y, along.x, 0};
  // From the right bank to the left one, so that discharge over it counts positive down the valley;
  // it ends where the sides stand 1 m above the crest.
  const auto bank = [&](const Vec3d& outwards) {
    double distance = 0;
    Vec3d point = centre;
    while (valley_elevation(point.x, point.y) < dam.crest + 1) {
      distance += 0.5;
      point = centre + distance * outwards;
    }
    return point;
  };
  dam.axis.vertices = {bank(-left), bank(left)};
  Notch notch;
  notch.centre = norm(dam.axis.vertices[0] - centre);
  notch.width = 10;
  notch.depth = 1.5;
  dam.notch = notch;
  return dam;
}

}  // namespace sabo
