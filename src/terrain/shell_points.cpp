#include "terrain/shell_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace sabo {
namespace {

constexpr int samples_across = 3;         // of a cell
constexpr int iterations = 20;            // of Lloyd; then places move by a hundredth of a spacing
constexpr double first_layer = 0.75;      // spacings: up to there a place belongs to it
constexpr double widest_gap = 0.9;        // spacings from a sample to the nearest first place
constexpr std::int64_t bias = 1ll << 20;  // cells fit into 21 bits each

using Cell = std::array<std::int64_t, 3>;

std::uint64_t key_of(const Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t n : cell) key = (key << 21) | static_cast<std::uint64_t>(n + bias);
  return key;
}

/// Lists of numbers by cell.
class CellLists {
 public:
  void add(const Cell& cell, std::uint32_t number) { lists_[key_of(cell)].push_back(number); }
  void clear() {
    for (auto& [key, list] : lists_) list.clear();
  }
  /// Of a cell and all around it.
  void collect(const Cell& cell, std::vector<std::uint32_t>& into) const {
    into.clear();
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const auto found = lists_.find(key_of({cell[0] + i, cell[1] + j, cell[2] + k}));
          if (found != lists_.end())
            into.insert(into.end(), found->second.begin(), found->second.end());
        }
  }

 private:
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> lists_;
};

class Shell {
 public:
  Shell(const Body& body, double spacing)
      : body_(body), spacing_(spacing), low_(body.bounds().low) {
    const Vec3d size = body.bounds().size();
    const auto cells = [&](double length) {
      return static_cast<std::int64_t>(std::ceil(length / spacing_ - 1e-9));
    };
    sample({0, 0, 0}, {cells(size.x), cells(size.y), cells(size.z)});
  }

  std::vector<GroundPoint> points(double density) {
    make_first_places();
    for (int k = 0; k < iterations; ++k) {
      move_to_centres();
      for (Vec3d& place : places_) settle(place);
    }
    const std::vector<Sum> sums = assign();
    const double grain = density * std::pow(spacing_ / samples_across, 3);
    std::vector<GroundPoint> points;
    for (std::size_t n = 0; n < places_.size(); ++n)
      if (sums[n].count > 0) points.push_back({places_[n], grain * sums[n].count});
    return points;
  }

 private:
  /// Samples in the solid of one cell.
  struct SampledCell {
    Cell cell;
    std::size_t first, last;
  };
  /// Samples that are nearest to a place.
  struct Sum {
    Vec3d place;
    int count = 0;
  };

  Vec3d corner(const Cell& cell) const {
    return low_ + spacing_ * Vec3d{double(cell[0]), double(cell[1]), double(cell[2])};
  }
  Cell cell_of(const Vec3d& point) const {
    const Vec3d at = (1 / spacing_) * (point - low_);
    return {std::int64_t(std::floor(at.x)), std::int64_t(std::floor(at.y)),
            std::int64_t(std::floor(at.z))};
  }

  /// Halves a block of cells until it is one, or out of reach of the surface.
  void sample(const Cell& first, const Cell& last) {
    const Vec3d low = corner(first), high = corner(last);
    const Vec3d centre = 0.5 * (low + high);
    const double radius = 0.501 * norm(high - low);
    const auto surface = body_.distance().nearest(centre, radius + body_.reach());
    if (!surface) return;
    if (surface->distance > radius && !body_.is_behind(centre)) return;
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (last[axis] - first[axis] > last[longest] - first[longest]) longest = axis;
    if (last[longest] - first[longest] <= 1) return sample_cell(first);
    Cell middle_last = last, middle_first = first;
    middle_last[longest] = middle_first[longest] = (first[longest] + last[longest]) / 2;
    sample(first, middle_last);
    sample(middle_first, last);
  }

  void sample_cell(const Cell& cell) {
    const std::size_t first = samples_.size();
    const double grain = spacing_ / samples_across;
    for (int i = 0; i < samples_across; ++i)
      for (int j = 0; j < samples_across; ++j)
        for (int k = 0; k < samples_across; ++k) {
          const Vec3d at = corner(cell) + grain * Vec3d{i + 0.5, j + 0.5, k + 0.5};
          if (body_.is_behind(at) && body_.distance().nearest(at, body_.reach()))
            samples_.push_back(at);
        }
    if (samples_.size() > first) cells_.push_back({cell, first, samples_.size()});
  }

  /// A place in each cell that is at least half full, and where else none would be near.
  void make_first_places() {
    const auto add = [this](const Vec3d& place) {
      lists_.add(cell_of(place), static_cast<std::uint32_t>(places_.size()));
      places_.push_back(place);
    };
    for (const SampledCell& c : cells_) {
      if (2 * (c.last - c.first) < samples_across * samples_across * samples_across) continue;
      Vec3d sum;
      for (std::size_t s = c.first; s < c.last; ++s) sum += samples_[s];
      add((1.0 / static_cast<double>(c.last - c.first)) * sum);
    }
    std::vector<std::uint32_t> near;
    for (const SampledCell& c : cells_) {
      for (std::size_t s = c.first; s < c.last; ++s) {
        lists_.collect(c.cell, near);
        const bool has_one = std::any_of(near.begin(), near.end(), [&](std::uint32_t n) {
          return norm(places_[n] - samples_[s]) < widest_gap * spacing_;
        });
        if (!has_one) add(samples_[s]);
      }
    }
  }

  std::vector<Sum> assign() {
    lists_.clear();
    for (std::size_t n = 0; n < places_.size(); ++n)
      lists_.add(cell_of(places_[n]), static_cast<std::uint32_t>(n));
    std::vector<Sum> sums(places_.size());
    std::vector<std::uint32_t> near;
    for (const SampledCell& c : cells_) {
      lists_.collect(c.cell, near);
      for (std::size_t s = c.first; s < c.last; ++s) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t nearest = places_.size();
        for (const std::uint32_t n : near) {
          const Vec3d way = samples_[s] - places_[n];
          const double square = dot(way, way);
          if (square >= least) continue;
          least = square;
          nearest = n;
        }
        if (nearest == places_.size()) continue;
        sums[nearest].place += samples_[s];
        ++sums[nearest].count;
      }
    }
    return sums;
  }

  void move_to_centres() {
    const std::vector<Sum> sums = assign();
    for (std::size_t n = 0; n < places_.size(); ++n)
      if (sums[n].count > 0) places_[n] = (1.0 / sums[n].count) * sums[n].place;
  }

  /// How far a place is behind the surface, m; negative before it.
  double depth_of(const Vec3d& place) const {
    const auto surface = body_.distance().nearest(place, body_.reach() + spacing_);
    if (!surface) return body_.reach() + spacing_;
    return body_.is_behind(place) ? surface->distance : -surface->distance;
  }

  /// Brings a place near the surface to half a spacing behind it, unless the solid is too thin;
  /// once for each face of a corner.
  void settle(Vec3d& place) const {
    for (int face = 0; face < 3; ++face)
      if (!settle_behind_nearest(place)) return;
  }

  /// Returns whether the place has moved.
  bool settle_behind_nearest(Vec3d& place) const {
    const double wanted = spacing_ / 2, rounding = 1e-9 * spacing_;
    const auto surface = body_.distance().nearest(place, first_layer * spacing_);
    if (!surface || surface->distance < rounding) return false;
    if (std::abs(surface->distance - wanted) < rounding) return false;
    const double side = body_.is_behind(place) ? 1 : -1;
    const Vec3d inwards = side / surface->distance * (place - surface->point);
    const Vec3d settled = surface->point + wanted * inwards;
    const double least = std::min(wanted, side * surface->distance);
    if (depth_of(settled) < least - rounding) return false;
    place = settled;
    return true;
  }

  const Body& body_;
  double spacing_;
  Vec3d low_;
  std::vector<Vec3d> samples_;
  std::vector<SampledCell> cells_;
  std::vector<Vec3d> places_;
  CellLists lists_;
};

}  // namespace

std::vector<GroundPoint> shell_points(const Body& body, double spacing, double density) {
  return Shell(body, spacing).points(density);
}

}  // namespace sabo
