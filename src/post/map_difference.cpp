#include "post/map_difference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/gis/round_length.hpp"
#include "io/gis/warp.hpp"

namespace sabo {
namespace {

void check_place(const RunMap& map, const RunMap& like) {
  const GdalErrors errors;
  const OGRSpatialReference own = crs_of(map.crs_wkt);
  const OGRSpatialReference other = crs_of(like.crs_wkt);
  if (is_unknown(own) && is_unknown(other)) return;
  if (!is_unknown(own) && !is_unknown(other) && same_place(own, other)) return;
  const auto name = [](const OGRSpatialReference& crs) {
    return is_unknown(crs) ? std::string("no known coordinate system") : name_of(crs);
  };
  throw CaseError(map.name,
                  fmt::format("is in {}, what it is compared with in {}", name(own), name(other)),
                  "compare what is in one coordinate system");
}

/// Edges that differ by less than a thousandth of a cell are the same.
bool is_same_grid(const Grid& a, const Grid& b) {
  const double slack = 1e-3 * std::min(a.dx, a.dy);
  return a.columns == b.columns && a.rows == b.rows && std::abs(a.west - b.west) < slack &&
         std::abs(a.north - b.north) < slack && std::abs(a.east() - b.east()) < slack &&
         std::abs(a.south() - b.south()) < slack;
}

/// Nothing where neither value counts.
bool counts(double a, double b, double threshold) {
  return !std::isnan(a) && !std::isnan(b) && (a > threshold || b > threshold);
}

}  // namespace

AlignedMap aligned(RunMap map, const RunMap& like) {
  check_place(map, like);
  AlignedMap result{std::move(map), ""};
  const Grid& grid = like.raster.grid;
  const Grid& own = result.map.raster.grid;
  if (is_same_grid(own, grid)) {
    result.map.raster.grid = grid;
    return result;
  }
  const WarpPlan plan{grid, grid.dx > own.dx * (1 + 1e-6)};
  result.note = fmt::format("resampled from {:g} x {:g} m to {:g} x {:g} m cells ({})", own.dx,
                            own.dy, grid.dx, grid.dy, plan.averages ? "means" : "bilinear");
  const GdalErrors errors;
  const OGRSpatialReference crs = crs_of(like.crs_wkt);
  result.map.raster = warp(result.map.raster, crs, plan, crs);
  return result;
}

Raster difference(const Raster& a, const Raster& b) {
  Raster result(a.grid);
  for (std::size_t cell = 0; cell < a.values.size(); ++cell)
    result.values[cell] = b.values[cell] - a.values[cell];
  return result;
}

DifferenceSummary summary_of(const Raster& a, const Raster& b, double threshold) {
  DifferenceSummary summary;
  std::vector<double> sizes;
  const double area = a.grid.cell_area();
  double sum = 0;
  for (std::size_t cell = 0; cell < a.values.size(); ++cell) {
    const double change = b.values[cell] - a.values[cell];
    if (std::isnan(change)) continue;
    summary.integral += change * area;
    summary.greatest_rise = std::max(summary.greatest_rise, change);
    summary.greatest_fall = std::min(summary.greatest_fall, change);
    if (!counts(a.values[cell], b.values[cell], threshold)) continue;
    summary.area += area;
    sum += std::abs(change);
    if (change != 0) sizes.push_back(std::abs(change));
  }
  if (summary.area > 0) summary.mean_absolute = sum * area / summary.area;
  if (!sizes.empty()) {
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::nth_element(sizes.begin(), middle, sizes.end());
    summary.scale = round_length(*middle);
  }
  return summary;
}

Raster shown_difference(const Raster& a, const Raster& b, double threshold) {
  Raster result = difference(a, b);
  for (std::size_t cell = 0; cell < a.values.size(); ++cell)
    if (!counts(a.values[cell], b.values[cell], threshold)) result.values[cell] = Raster::no_data;
  return result;
}

}  // namespace sabo
