#include "analysis/spreader.hpp"

#include <cmath>
#include <limits>

namespace sabo {
namespace {

/// Nearest number in [low, high]; NaN becomes `low`.
double clamped(double value, double low, double high) {
  return value > low ? std::min(value, high) : low;
}

}  // namespace

Spreader::Spreader(const Raster& elevation, double spacing)
    : grid_(elevation.grid),
      inside_(elevation.values.size()),
      has_inside_(false),
      width_(std::max(1.0, 2 * spacing / grid_.dx)),
      height_(std::max(1.0, 2 * spacing / grid_.dy)) {
  for (std::size_t cell = 0; cell < inside_.size(); ++cell) {
    inside_[cell] = std::isnan(elevation.values[cell]) ? 0 : 1;
    has_inside_ = has_inside_ || inside_[cell] != 0;
  }
}

Spreader::Range Spreader::range(double centre, double width, int cells) {
  const double from = clamped(centre - width / 2, 0, cells);
  const double to = clamped(centre + width / 2, 0, cells);
  return {from, to, static_cast<int>(from), static_cast<int>(std::ceil(to)) - 1};
}

std::size_t Spreader::nearest_inside(double x, double y) const {
  const double column = clamped((x - grid_.west) / grid_.dx, 0, grid_.columns);
  const double row = clamped((grid_.north - y) / grid_.dy, 0, grid_.rows);
  const int centre_column = std::min(static_cast<int>(column), grid_.columns - 1);
  const int centre_row = std::min(static_cast<int>(row), grid_.rows - 1);

  std::size_t nearest = 0;
  double nearest_distance = std::numeric_limits<double>::infinity();
  const auto consider = [&](int c, int r) {
    if (!grid_.has_cell(c, r) || !is_inside(grid_.index(c, r))) return;
    const double distance = std::hypot((c + 0.5 - column) * grid_.dx, (r + 0.5 - row) * grid_.dy);
    if (distance >= nearest_distance) return;
    nearest_distance = distance;
    nearest = grid_.index(c, r);
  };
  // Square rings of growing radius; the centres of ring k are at least k - 1/2 cells away.
  const int last_ring = std::max(grid_.columns, grid_.rows);
  for (int ring = 0; ring <= last_ring; ++ring) {
    if ((ring - 0.5) * std::min(grid_.dx, grid_.dy) > nearest_distance) break;
    for (int c = centre_column - ring; c <= centre_column + ring; ++c) {
      consider(c, centre_row - ring);
      consider(c, centre_row + ring);
    }
    for (int r = centre_row - ring + 1; r < centre_row + ring; ++r) {
      consider(centre_column - ring, r);
      consider(centre_column + ring, r);
    }
  }
  return nearest;
}

}  // namespace sabo
