#include "terrain/release.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <sstream>
#include <utility>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double most_particles = 1e8;
constexpr double most_columns = 1e9;

void refuse_unless_fits(double count, double most) {
  if (count <= most) return;
  throw CaseError("numerics.spacing", "the release would have too many particles",
                  "raise the spacing or check the size of the release");
}

void refuse_unless_inside(const Surface& surface, double x, double y, const Frame& frame) {
  if (surface.inside(x, y)) return;
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(2);
  text << "the release lies outside the DEM at (" << x + frame.origin_x << ", "
       << y + frame.origin_y << ")";
  const Grid& grid = surface.elevation().grid;
  std::ostringstream remedy;
  remedy.setf(std::ios::fixed);
  remedy.precision(0);
  remedy << "give coordinates where the DEM has data, within x " << grid.west + frame.origin_x
         << " to " << grid.east() + frame.origin_x << " and y " << grid.south() + frame.origin_y
         << " to " << grid.north + frame.origin_y;
  throw CaseError("release", text.str(), remedy.str());
}

/// Lattice numbers k whose sites (k + 1/2) spacing lie in [low, high).
std::pair<std::int64_t, std::int64_t> sites_between(double low, double high, double spacing) {
  const auto first = [&](double edge) {
    return static_cast<std::int64_t>(std::ceil(edge / spacing - 0.5));
  };
  return {first(low), first(high)};
}

/// Calls visit(x, y) for each lattice column over the shape.
template <class Visit>
void for_each_column(const ReleaseShape& shape, double spacing, Visit&& visit) {
  refuse_unless_fits((shape.east - shape.west) / spacing * (shape.north - shape.south) / spacing,
                     most_columns);
  const auto [west, east] = sites_between(shape.west, shape.east, spacing);
  const auto [south, north] = sites_between(shape.south, shape.north, spacing);
  for (std::int64_t i = west; i < east; ++i) {
    for (std::int64_t j = south; j < north; ++j) visit((i + 0.5) * spacing, (j + 0.5) * spacing);
  }
}

/// `shares`: what each particle stands for, in any unit; the volume is shared out by them.
Particles at_rest(std::vector<Vec3d> positions, const std::vector<double>& shares, double volume,
                  double density) {
  if (positions.empty()) {
    throw CaseError("numerics.spacing", "the release is too thin to hold a single particle",
                    "choose a smaller spacing");
  }
  Particles particles;
  particles.resize(positions.size());
  const double per_share = volume * density / std::accumulate(shares.begin(), shares.end(), 0.0);
  for (std::size_t k = 0; k < shares.size(); ++k) particles.mass[k] = per_share * shares[k];
  std::fill(particles.density.begin(), particles.density.end(), density);
  std::iota(particles.id.begin(), particles.id.end(), 0U);
  particles.position = std::move(positions);
  return particles;
}

/// Of particles that are all alike.
Particles at_rest(std::vector<Vec3d> positions, double volume, double density) {
  const std::vector<double> equal(positions.size(), 1.0);
  return at_rest(std::move(positions), equal, volume, density);
}

/// Sites above the ground of the cubic lattice that lie in a cube around any of the points.
std::vector<Vec3d> sites_in_cubes(const Surface& surface, const std::vector<Vec3d>& points,
                                  double side, double spacing) {
  std::vector<std::array<std::int64_t, 3>> sites;
  for (const Vec3d& p : points) {
    const auto [west, east] = sites_between(p.x - side / 2, p.x + side / 2, spacing);
    const auto [south, north] = sites_between(p.y - side / 2, p.y + side / 2, spacing);
    const auto [low, high] = sites_between(p.z - side / 2, p.z + side / 2, spacing);
    for (std::int64_t i = west; i < east; ++i) {
      for (std::int64_t j = south; j < north; ++j) {
        for (std::int64_t k = low; k < high; ++k) sites.push_back({i, j, k});
      }
    }
  }
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  std::vector<Vec3d> positions;
  for (const auto& [i, j, k] : sites) {
    const Vec3d site = spacing * Vec3d{i + 0.5, j + 0.5, k + 0.5};
    if (site.z > surface.height(site.x, site.y)) positions.push_back(site);
  }
  return positions;
}

/// A list in another vertical datum than the DEM is the usual reason.
void refuse_points_below(const Surface& surface, const std::vector<Vec3d>& points) {
  std::size_t count = 0;
  double deepest = 0;
  for (const Vec3d& p : points) {
    const double depth = surface.height(p.x, p.y) - p.z;
    if (depth > 0) ++count;
    deepest = std::max(deepest, depth);
  }
  if (count == 0) return;
  throw CaseError("release.points",
                  std::to_string(count) + " of " + std::to_string(points.size()) +
                      " points lie below the ground, by up to " + std::to_string(deepest) + " m",
                  "check points_offset and the heights' datum");
}

}  // namespace

ReleaseShape release_of(std::vector<ThickPolygon> polygons) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ReleaseShape shape{{}, infinity, infinity, -infinity, -infinity};
  for (const auto& [polygon, thickness] : polygons) {
    shape.area += area(polygon);
    shape.volume += thickness * area(polygon);
    for (const std::vector<Vec3d>& ring : polygon.rings) {
      for (const Vec3d& vertex : ring) {
        shape.west = std::min(shape.west, vertex.x);
        shape.east = std::max(shape.east, vertex.x);
        shape.south = std::min(shape.south, vertex.y);
        shape.north = std::max(shape.north, vertex.y);
      }
    }
  }
  if (!(shape.volume > 0)) {
    throw CaseError("release.polygon", "the release has no volume",
                    "give a polygon with an area, and a thickness above 0");
  }
  shape.thickness = [shared = std::make_shared<std::vector<ThickPolygon>>(std::move(polygons))](
                        double x, double y) {
    const auto found = std::ranges::find_if(
        *shared, [&](const ThickPolygon& p) { return contains(p.polygon, x, y); });
    return found == shared->end() ? 0.0 : found->thickness;
  };
  return shape;
}

ReleaseShape release_of(Raster thickness) {
  const Grid grid = thickness.grid;
  ReleaseShape shape{{}, grid.west, grid.south(), grid.east(), grid.north};
  for (double& value : thickness.values) {
    if (!(value > 0 && std::isfinite(value))) value = 0;
    shape.area += value > 0 ? grid.cell_area() : 0;
    shape.volume += value * grid.cell_area();
  }
  if (!(shape.volume > 0)) {
    throw CaseError("release.thickness_raster", "the release has no volume",
                    "give a raster with thickness above 0");
  }
  shape.thickness = [raster = std::make_shared<Raster>(std::move(thickness))](double x, double y) {
    const int column = raster->grid.column_of(x);
    const int row = raster->grid.row_of(y);
    return raster->grid.has_cell(column, row) ? raster->at(column, row) : 0.0;
  };
  return shape;
}

ReleaseShape made_vertical(const ReleaseShape& shape, const Surface& surface, double spacing) {
  ReleaseShape vertical = shape;
  vertical.thickness = [normal = shape.thickness, &surface](double x, double y) {
    const double thickness = normal(x, y);
    return thickness > 0 ? thickness / surface.normal(x, y).z : 0;
  };
  // Both by the same sum, so that the error at the rim of the shape cancels.
  double normal_sum = 0;
  double vertical_sum = 0;
  for_each_column(shape, spacing / 4, [&](double x, double y) {
    normal_sum += shape.thickness(x, y);
    vertical_sum += vertical.thickness(x, y);
  });
  if (normal_sum > 0) vertical.volume = shape.volume * vertical_sum / normal_sum;
  return vertical;
}

ReleaseShape scaled_to(const ReleaseShape& shape, double volume) {
  ReleaseShape scaled = shape;
  scaled.thickness = [original = shape.thickness, factor = volume / shape.volume](
                         double x, double y) { return factor * original(x, y); };
  scaled.volume = volume;
  return scaled;
}

Particles released(const Surface& surface, const ReleaseShape& shape,
                   const ReleaseSettings& settings) {
  const double spacing = settings.spacing;
  refuse_unless_fits(shape.volume / (spacing * spacing * spacing), most_particles);
  std::vector<Vec3d> positions;
  std::vector<double> steps;
  double owed = 0;  // by columns too thin for a particle, m
  for_each_column(shape, spacing, [&](double x, double y) {
    double thickness = shape.thickness(x, y);
    if (!(thickness > 0)) return;
    std::int64_t count = std::llround(thickness / spacing);
    if (count == 0) {
      owed += thickness;
      if (owed < spacing / 2) return;
      thickness = std::exchange(owed, 0.0);
      count = 1;
    }
    refuse_unless_inside(surface, x, y, settings.frame);
    const double ground = surface.height(x, y);
    const double step = thickness / static_cast<double>(count);
    for (std::int64_t k = 0; k < count; ++k) positions.push_back({x, y, ground + (k + 0.5) * step});
    steps.resize(positions.size(), step);
  });
  return at_rest(std::move(positions), steps, shape.volume, settings.density);
}

Particles released(const Surface& surface, const std::vector<Vec3d>& points, double point_volume,
                   const ReleaseSettings& settings) {
  if (points.empty()) throw CaseError("release.points", "the list of points is empty");
  for (const Vec3d& p : points) refuse_unless_inside(surface, p.x, p.y, settings.frame);
  refuse_points_below(surface, points);
  const double side = std::cbrt(point_volume);
  const double volume = point_volume * static_cast<double>(points.size());
  if (std::abs(side - settings.spacing) <= 1e-6) return at_rest(points, volume, settings.density);
  const double spacing = settings.spacing;
  refuse_unless_fits(volume / (spacing * spacing * spacing), most_particles);
  return at_rest(sites_in_cubes(surface, points, side, spacing), volume, settings.density);
}

BoxColumns box_columns(const Bounds& box, double spacing) {
  const Vec3d size = box.size();
  const auto parts = [spacing](double length) {
    return std::max<std::int64_t>(1, std::llround(length / spacing));
  };
  const std::int64_t x = parts(size.x), y = parts(size.y);
  return {x, y, size.x / static_cast<double>(x), size.y / static_cast<double>(y)};
}

Particles released_box(const Surface& surface, const Bounds& box, const std::vector<Body>& bodies,
                       const ReleaseSettings& settings) {
  const double spacing = settings.spacing;
  const Vec3d size = box.size();
  refuse_unless_fits(size.x * size.y * size.z / (spacing * spacing * spacing), most_particles);
  const auto is_free = [&](const Vec3d& place) {
    return std::none_of(bodies.begin(), bodies.end(), [&](const Body& body) {
      return body.contains(place) || body.distance().nearest(place, spacing / 4);
    });
  };
  const auto [columns, rows, dx, dy] = box_columns(box, spacing);
  std::vector<Vec3d> positions;
  std::vector<double> steps;
  double volume = 0;
  for (std::int64_t i = 0; i < columns; ++i) {
    for (std::int64_t j = 0; j < rows; ++j) {
      const double x = box.low.x + (i + 0.5) * dx, y = box.low.y + (j + 0.5) * dy;
      refuse_unless_inside(surface, x, y, settings.frame);
      const double bottom = std::max(box.low.z, surface.height(x, y));
      const std::int64_t count = std::llround((box.high.z - bottom) / spacing);
      const double step = (box.high.z - bottom) / static_cast<double>(count);
      for (std::int64_t k = 0; k < count; ++k) {
        const Vec3d place{x, y, bottom + (k + 0.5) * step};
        if (!is_free(place)) continue;
        positions.push_back(place);
        steps.push_back(step);
        volume += dx * dy * step;
      }
    }
  }
  return at_rest(std::move(positions), steps, volume, settings.density);
}

}  // namespace sabo
