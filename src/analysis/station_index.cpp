#include "analysis/station_index.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Points sorted into square bins of equal size, in plan.
struct Bins {
  static constexpr double points_per_bin = 64;

  double west = infinity;
  double south = infinity;
  double size = 0;
  std::size_t columns = 1;
  std::vector<std::uint32_t> rows;   // of the points, bin by bin
  std::vector<std::uint32_t> first;  // of each bin in `rows`, and the end

  explicit Bins(const std::vector<Vec3d>& points) {
    double east = -infinity;
    double north = -infinity;
    for (const Vec3d& point : points) {
      west = std::min(west, point.x);
      east = std::max(east, point.x);
      south = std::min(south, point.y);
      north = std::max(north, point.y);
    }
    const double width = east - west;
    const double height = north - south;
    const double even =
        std::sqrt(width * height * points_per_bin / static_cast<double>(points.size()));
    size = std::max({even, std::max(width, height) / 1000, 1e-6});
    columns = static_cast<std::size_t>(width / size) + 1;
    const std::size_t count = columns * (static_cast<std::size_t>(height / size) + 1);

    // Counting sort.
    first.assign(count + 1, 0);
    for (const Vec3d& point : points) ++first[bin_of(point) + 1];
    for (std::size_t bin = 0; bin < count; ++bin) first[bin + 1] += first[bin];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    rows.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      rows[next[bin_of(points[i])]++] = static_cast<std::uint32_t>(i);
    }
  }

  std::size_t bin_of(const Vec3d& point) const {
    return static_cast<std::size_t>((point.y - south) / size) * columns +
           static_cast<std::size_t>((point.x - west) / size);
  }
  double x_of(std::size_t bin) const {
    const std::size_t column = bin % columns;
    return west + (static_cast<double>(column) + 0.5) * size;
  }
  double y_of(std::size_t bin) const {
    const std::size_t row = bin / columns;
    return south + (static_cast<double>(row) + 0.5) * size;
  }
  /// Reaches a little over the corners, for rounding.
  double radius() const { return 0.7072 * size; }
};

/// (value, weight): mean of the greatest values up to a weight; the last counts in part.
double mean_of_greatest(std::vector<std::pair<double, double>>& weighted, double weight) {
  std::sort(weighted.begin(), weighted.end(), std::greater<>());
  double sum = 0;
  double left = weight;
  for (const auto& [value, available] : weighted) {
    const double taken = std::min(available, left);
    sum += taken * value;
    left -= taken;
    if (!(left > 0)) break;
  }
  return sum / (weight - left);
}

}  // namespace

StationIndex::StationIndex(const Polyline& path) {
  path_.has_z = path.has_z;
  for (const Vec3d& vertex : path.vertices) {
    double station = 0;
    if (!path_.vertices.empty()) {
      const Vec3d step = vertex - path_.vertices.back();
      if (step.x == 0 && step.y == 0) continue;
      station = stations_.back() + std::hypot(step.x, step.y);
    }
    path_.vertices.push_back(vertex);
    stations_.push_back(station);
  }
  if (path_.vertices.size() < 2) {
    throw CaseError("path.line", "the path has fewer than two different vertices",
                    "give a line along the valley");
  }
}

// A point of the disc is at most (distance of the centre + radius) from the path, and a piece is
// farther from it than (its distance from the centre - radius).
StationIndex::Candidates StationIndex::candidates(double x, double y, double radius) const {
  const std::size_t pieces = path_.vertices.size() - 1;
  std::vector<double> squares(pieces);
  double least = infinity;
  for (std::size_t k = 0; k < pieces; ++k) {
    const Vec3d along = path_.vertices[k + 1] - path_.vertices[k];
    const double px = x - path_.vertices[k].x;
    const double py = y - path_.vertices[k].y;
    double t = (px * along.x + py * along.y) / (along.x * along.x + along.y * along.y);
    if (k > 0) t = std::max(t, 0.0);
    if (k + 1 < pieces) t = std::min(t, 1.0);
    const double dx = px - t * along.x;
    const double dy = py - t * along.y;
    squares[k] = dx * dx + dy * dy;
    least = std::min(least, squares[k]);
  }
  const double limit = (std::sqrt(least) + 2 * radius) * (std::sqrt(least) + 2 * radius);
  Candidates near{pieces, 0, 0, 0};
  for (std::size_t k = 0; k < pieces; ++k) {
    if (squares[k] > limit) continue;
    near.first = std::min(near.first, k);
    near.last = k;
  }
  near.lowest = near.first == 0 ? -infinity : stations_[near.first];
  near.highest = near.last + 1 == pieces ? infinity : stations_[near.last + 1];
  return near;
}

/// The candidates with one piece more on either side.
Polyline StationIndex::stretch(const Candidates& near) const {
  const std::size_t first = near.first > 0 ? near.first - 1 : 0;
  const std::size_t last = std::min(near.last + 2, path_.vertices.size() - 1);
  const auto begin = path_.vertices.begin();
  return {
      {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last) + 1},
      path_.has_z};
}

// The stretch contains the nearest piece, but its ends are continued straight where the path
// bends; a point projected there is projected again on the whole path.
double StationIndex::station(const Vec3d& point, const Candidates& near,
                             const Polyline& stretch) const {
  const std::size_t first = near.first > 0 ? near.first - 1 : 0;
  const std::size_t last = first + stretch.vertices.size() - 1;
  const double station = stations_[first] + project(stretch, point.x, point.y).station;
  const bool is_before = first > 0 && station <= stations_[first];
  const bool is_behind = last + 1 < path_.vertices.size() && station >= stations_[last];
  return is_before || is_behind ? project(path_, point.x, point.y).station : station;
}

std::optional<double> StationIndex::foremost(const std::vector<Vec3d>& points,
                                             const std::vector<double>& masses,
                                             double share) const {
  if (points.empty()) return std::nullopt;
  const Bins bins(points);

  struct Bin {
    Candidates near;
    std::size_t number;
    double mass;
  };
  std::vector<Bin> occupied;
  double total = 0;
  for (std::size_t b = 0; b + 1 < bins.first.size(); ++b) {
    if (bins.first[b] == bins.first[b + 1]) continue;
    double mass = 0;
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; ++k) mass += masses[bins.rows[k]];
    occupied.push_back({candidates(bins.x_of(b), bins.y_of(b), bins.radius()), b, mass});
    total += mass;
  }
  if (!(total > 0)) return std::nullopt;

  // Bins behind the share that lies ahead of some station for certain hold none of it.
  std::sort(occupied.begin(), occupied.end(),
            [](const Bin& a, const Bin& b) { return a.near.lowest > b.near.lowest; });
  double ahead = 0;
  double threshold = -infinity;
  for (const Bin& bin : occupied) {
    ahead += bin.mass;
    threshold = bin.near.lowest;
    if (ahead >= share * total) break;
  }
  std::vector<std::pair<double, double>> weighted;
  for (const Bin& bin : occupied) {
    if (bin.near.highest < threshold) continue;
    const Polyline part = stretch(bin.near);
    for (std::uint32_t k = bins.first[bin.number]; k < bins.first[bin.number + 1]; ++k) {
      const std::uint32_t row = bins.rows[k];
      weighted.emplace_back(station(points[row], bin.near, part), masses[row]);
    }
  }
  return mean_of_greatest(weighted, share * total);
}

}  // namespace sabo
