#include "terrain/ground_columns.hpp"

#include <algorithm>
#include <cmath>

#include "terrain/inset_height.hpp"

namespace sabo {
namespace {

constexpr double longest_stretch = 1.25;  // of the lattice along the ground before a split
constexpr int most_parts = 4;             // of a column, per direction
constexpr double steepest_secant = 3;     // 1 / cos(slope): at cliffs layers stop growing apart
constexpr double largest_piece = 1.2;     // of a layer of broken ground, in squared spacings
constexpr int most_halvings = 6;          // of a column of broken ground
constexpr double crest_depth = 0.3;       // of the first particle in a crest thinner than a
constexpr double crest_gap = 0.35;        // spacing; and by how much the first layer may miss it

/// Parts into which a slope splits a column.
int parts(double slope) {
  return std::min(static_cast<int>(std::ceil(std::hypot(1, slope) / longest_stretch)), most_parts);
}

}  // namespace

/// Where a column meets the ground.
struct GroundColumns::Foot {
  Vec3d point;
  double slope_x = 0;
  double slope_y = 0;

  double secant() const {
    return std::min(std::sqrt(1 + slope_x * slope_x + slope_y * slope_y), steepest_secant);
  }

  /// The tangent plane at another place; no steeper than the layers are.
  Foot moved_to(double x, double y) const {
    const double run = std::hypot(x - point.x, y - point.y);
    const double rise = slope_x * (x - point.x) + slope_y * (y - point.y);
    Foot foot = *this;
    foot.point = {x, y, point.z + std::clamp(rise, -steepest_secant * run, steepest_secant * run)};
    return foot;
  }
};

GroundColumns::GroundColumns(const Surface& surface, const GroundSettings& settings)
    : surface_(surface), settings_(settings) {
  const int most = settings.layers + 1;
  for (int right = -most; right <= most; ++right) {
    for (int up = -most; up <= most; ++up) {
      if (right * right + up * up <= most * most) offsets_.push_back({right, up});
    }
  }
  const auto square = [](const std::array<int, 2>& step) {
    return step[0] * step[0] + step[1] * step[1];
  };
  std::stable_sort(offsets_.begin(), offsets_.end(),
                   [&](const auto& a, const auto& b) { return square(a) < square(b); });
}

void GroundColumns::make(std::int64_t i, std::int64_t j, bool beyond_edge,
                         std::vector<GroundPoint>& into) const {
  Foot whole;
  if (!find_foot(i, j, beyond_edge, whole)) return;
  if (is_broken(whole)) {
    const Piece column{whole.point.x, whole.point.y, settings_.spacing, settings_.spacing};
    for (int layer = 0; layer < settings_.layers; ++layer) {
      fill(column, layer, most_halvings, into);
    }
    return;
  }
  const int parts_x = parts(whole.slope_x);
  const int parts_y = parts(whole.slope_y);
  const double area = settings_.spacing * settings_.spacing / (parts_x * parts_y);
  for (int a = 0; a < parts_x; ++a) {
    for (int b = 0; b < parts_y; ++b) {
      const double x = (i + (a + 0.5) / parts_x) * settings_.spacing;
      const double y = (j + (b + 0.5) / parts_y) * settings_.spacing;
      const Foot foot = surface_.inside(x, y) ? foot_at(x, y) : whole.moved_to(x, y);
      const double step = settings_.spacing * foot.secant();
      for (int k = 0; k < settings_.layers; ++k) {
        into.push_back(
            {foot.point - Vec3d{0, 0, (k + 0.5) * step}, settings_.density * area * step});
      }
    }
  }
}

/// Whether the shell under a column is half a layer thicker or thinner than its tangent plane says.
bool GroundColumns::is_broken(const Foot& foot) const {
  const auto& [x, y, z] = foot.point;
  if (!surface_.inside(x, y)) return false;
  if (foot.secant() == steepest_secant) return true;
  const double depth = settings_.layers * settings_.spacing;
  const double thickness = (z - inset_height(surface_, x, y, depth)) / foot.secant();
  return std::abs(thickness - depth) > settings_.spacing / 2;
}

/// Elevation of a layer in broken ground: the surface moved inwards.
double GroundColumns::layer_height(double x, double y, int layer) const {
  const double height = inset_height(surface_, x, y, (layer + 0.5) * settings_.spacing);
  if (layer > 0) return height;
  // A crest too thin to hold a point half a spacing deep would stay empty.
  const double crest = inset_height(surface_, x, y, crest_depth * settings_.spacing);
  return std::max(height, crest - crest_gap * settings_.spacing);
}

/// Puts particles on a piece of a layer; halves it until one can stand for it.
void GroundColumns::fill(const Piece& piece, int layer, int halvings,
                         std::vector<GroundPoint>& into) const {
  // Copies: clang 14 has no structured bindings in lambdas.
  const double x = piece.x, y = piece.y, width = piece.width, length = piece.length;
  const double z = layer_height(x, y, layer);
  const auto climb = [&](double dx, double dy) {
    return std::abs(layer_height(x + dx, y + dy, layer) - z) +
           std::abs(layer_height(x - dx, y - dy, layer) - z);
  };
  const double climb_x = climb(width / 2, 0);
  const double climb_y = climb(0, length / 2);
  const double area = norm(Vec3d{width * length, climb_x * length, climb_y * width});
  const double largest = largest_piece * settings_.spacing * settings_.spacing;
  if (area <= largest || halvings == 0) {
    const double mass = settings_.density * settings_.spacing * std::min(area, largest);
    into.push_back({{x, y, z}, mass});
  } else if (std::hypot(width, climb_x) >= std::hypot(length, climb_y)) {
    fill({x - width / 4, y, width / 2, length}, layer, halvings - 1, into);
    fill({x + width / 4, y, width / 2, length}, layer, halvings - 1, into);
  } else {
    fill({x, y - length / 4, width, length / 2}, layer, halvings - 1, into);
    fill({x, y + length / 4, width, length / 2}, layer, halvings - 1, into);
  }
}

/// The foot of a lattice column, on the tangent plane of the nearest column inside the domain if it
/// stands outside.
bool GroundColumns::find_foot(std::int64_t i, std::int64_t j, bool beyond_edge, Foot& foot) const {
  for (const auto& [right, up] : offsets_) {
    const double x = centre(i + right);
    const double y = centre(j + up);
    if (surface_.inside(x, y)) {
      foot = foot_at(x, y).moved_to(centre(i), centre(j));
      return true;
    }
    if (!beyond_edge) return false;
  }
  return false;
}

GroundColumns::Foot GroundColumns::foot_at(double x, double y) const {
  // Averaged over a column or a cell, whichever is wider, so that rough ground does not make
  // neighbouring columns differ in their layers.
  const Grid& grid = surface_.elevation().grid;
  const double half_x = std::max(settings_.spacing, grid.dx) / 2;
  const double half_y = std::max(settings_.spacing, grid.dy) / 2;
  return {{x, y, surface_.height(x, y)}, slope(x, y, half_x, 0), slope(x, y, 0, half_y)};
}

/// Rise over run along (dx, dy), one of which is 0; one-sided at an edge of the domain.
double GroundColumns::slope(double x, double y, double dx, double dy) const {
  const bool has_ahead = surface_.inside(x + dx, y + dy);
  const bool has_behind = surface_.inside(x - dx, y - dy);
  if (!has_ahead && !has_behind) return 0;
  const double ahead = has_ahead ? surface_.height(x + dx, y + dy) : surface_.height(x, y);
  const double behind = has_behind ? surface_.height(x - dx, y - dy) : surface_.height(x, y);
  return (ahead - behind) / ((has_ahead + has_behind) * (dx + dy));
}

}  // namespace sabo
