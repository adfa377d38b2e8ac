#include "terrain/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/nearest_on_triangle.hpp"

#include "base/error.hpp"

namespace sabo {

/// Four cell centres around a point, and where between them it lies: `u` from west to east and `v`
/// from north to south, both in [0, 1].
struct Surface::Square {
  int column = 0;
  int row = 0;
  double u = 0;
  double v = 0;
  bool is_exact = false;  ///< false where the point was clamped to the raster

  bool is_north_east() const { return u > v; }
};

namespace {

/// Fills cells without data by spreading the values around them, nearest first.
std::vector<double> extended(const Raster& elevation) {
  const Grid& grid = elevation.grid;
  std::vector<double> values = elevation.values;
  std::vector<std::size_t> front;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isnan(values[k])) front.push_back(k);
  }
  if (front.size() == values.size()) return values;
  for (std::size_t next = 0; next < front.size(); ++next) {
    const int column = grid.column_at(front[next]);
    const int row = grid.row_at(front[next]);
    constexpr std::array<std::array<int, 2>, 8> steps{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (const auto& [right, down] : steps) {
      if (!grid.has_cell(column + right, row + down)) continue;
      const std::size_t neighbour = grid.index(column + right, row + down);
      if (!std::isnan(values[neighbour])) continue;
      values[neighbour] = values[front[next]];
      front.push_back(neighbour);
    }
  }
  return values;
}

/// Position in cells from the first cell centre, kept in [0, last]; NaN becomes 0.
double clamped(double position, double last) { return position > 0 ? std::min(position, last) : 0; }

}  // namespace

Surface::Surface(Raster elevation) : elevation_(std::move(elevation)) {
  const Grid& grid = elevation_.grid;
  if (grid.columns < 2 || grid.rows < 2) {
    throw CaseError("terrain.dem", "the DEM has fewer than 2 x 2 cells", "use a larger DEM");
  }
  for (double& z : elevation_.values) {
    if (!std::isfinite(z)) z = Raster::no_data;
  }
  extended_ = extended(elevation_);
  if (std::isnan(extended_[0])) {
    throw CaseError("terrain.dem", "the DEM has no cell with data", "check its no-data value");
  }
}

Surface::Square Surface::square_at(double x, double y) const {
  const Grid& grid = elevation_.grid;
  const double across = (x - grid.west) / grid.dx - 0.5;
  const double down = (grid.north - y) / grid.dy - 0.5;
  Square square;
  square.u = clamped(across, grid.columns - 1);
  square.v = clamped(down, grid.rows - 1);
  square.is_exact = square.u == across && square.v == down;
  square.column = std::min(static_cast<int>(square.u), grid.columns - 2);
  square.row = std::min(static_cast<int>(square.v), grid.rows - 2);
  square.u -= square.column;
  square.v -= square.row;
  return square;
}

bool Surface::inside(double x, double y) const {
  const Square square = square_at(x, y);
  if (!square.is_exact) return false;
  const double third = square.is_north_east() ? elevation_.at(square.column + 1, square.row)
                                              : elevation_.at(square.column, square.row + 1);
  return std::isfinite(elevation_.at(square.column, square.row) + third +
                       elevation_.at(square.column + 1, square.row + 1));
}

double Surface::height(double x, double y) const {
  const Square square = square_at(x, y);
  const std::size_t north = elevation_.grid.index(square.column, square.row);
  const std::size_t south = north + elevation_.grid.columns;
  const double north_west = extended_[north];
  const double south_east = extended_[south + 1];
  const double third = square.is_north_east() ? extended_[north + 1] : extended_[south];
  return square.is_north_east()
             ? north_west + (third - north_west) * square.u + (south_east - third) * square.v
             : north_west + (third - north_west) * square.v + (south_east - third) * square.u;
}

Vec3d Surface::normal(double x, double y) const {
  const Square square = square_at(x, y);
  const Grid& grid = elevation_.grid;
  const std::size_t north = grid.index(square.column, square.row);
  const std::size_t south = north + grid.columns;
  const double eastward = square.is_north_east() ? extended_[north + 1] - extended_[north]
                                                 : extended_[south + 1] - extended_[south];
  const double southward = square.is_north_east() ? extended_[south + 1] - extended_[north + 1]
                                                  : extended_[south] - extended_[north];
  return normalised(Vec3d{-eastward / grid.dx, southward / grid.dy, 1});
}

std::optional<SurfacePoint> Surface::nearest(const Vec3d& point, double reach) const {
  const Grid& grid = elevation_.grid;
  std::optional<SurfacePoint> best;
  if (inside(point.x, point.y)) {
    // The place straight above or below bounds the search.
    const Vec3d foot{point.x, point.y, height(point.x, point.y)};
    const double vertical = std::abs(point.z - foot.z);
    if (vertical <= reach) best = {foot, normal(point.x, point.y), vertical};
  }
  if (best) reach = best->distance;
  const Square first = square_at(point.x - reach, point.y + reach);
  const Square last = square_at(point.x + reach, point.y - reach);
  for (int row = first.row; row <= last.row; ++row) {
    for (int column = first.column; column <= last.column; ++column) {
      const auto vertex = [&](int c, int r) {
        return Vec3d{grid.x_of(c), grid.y_of(r), elevation_.at(c, r)};
      };
      const Vec3d north_west = vertex(column, row);
      const Vec3d north_east = vertex(column + 1, row);
      const Vec3d south_west = vertex(column, row + 1);
      const Vec3d south_east = vertex(column + 1, row + 1);
      for (const Vec3d& third : {north_east, south_west}) {
        if (!std::isfinite(north_west.z + third.z + south_east.z)) continue;
        const auto [low, high] = std::minmax({north_west.z, third.z, south_east.z});
        if (low > point.z + reach || high < point.z - reach) continue;
        const Vec3d candidate = nearest_on_triangle(point, north_west, third, south_east);
        const double distance = norm(point - candidate);
        if (distance > reach || (best && distance >= best->distance)) continue;
        const Vec3d up = cross(south_east - north_west, third - north_west);
        best = {candidate, normalised(up.z > 0 ? up : -up), distance};
        reach = distance;
      }
    }
  }
  return best;
}

}  // namespace sabo
