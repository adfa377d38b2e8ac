#include "terrain/dam_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace sabo {
namespace {

constexpr double sharpest_mitre = 3;  // of a bend, in half thicknesses
constexpr double most_pieces = 2000;  // of a dam, along its line

// Corners 0 to 3 around the foot of a block, anticlockwise from above, 4 to 7 over them.
constexpr Triangle block_triangles[] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                        {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                        {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

/// What lies a distance of 1 m to the left of the axis at a station, mitred in a bend.
Vec3d aside(const CheckDam& dam, double station) {
  const double hair = 1e-6 * length(dam.axis);
  const Vec3d before = direction_at(dam.axis, station - hair);
  const Vec3d after = direction_at(dam.axis, station + hair);
  const Vec3d sum = before + after;
  const double cosine = norm(sum) / 2;  // of half the angle of the bend
  if (cosine < 1 / sharpest_mitre) return {-before.y, before.x, 0};
  return 1 / (2 * cosine * cosine) * Vec3d{-sum.y, sum.x, 0};
}

/// A piece of the dam between two stations and two distances from the axis.
struct Block {
  double from, to;
  double right, left;

  std::array<Vec3d, 4> corners(const CheckDam& dam) const {
    const Vec3d a = point_at(dam.axis, from), b = point_at(dam.axis, to);
    const Vec3d at_a = aside(dam, from), at_b = aside(dam, to);
    return {a + right * at_a, b + right * at_b, b + left * at_b, a + left * at_a};
  }
};

std::optional<double> lowest_ground(const std::array<Vec3d, 4>& corners, const Surface& surface) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3d& corner : corners) {
    if (!surface.inside(corner.x, corner.y)) return {};
    lowest = std::min(lowest, surface.height(corner.x, corner.y));
  }
  return lowest;
}

/// Upper edges at both ends of a block, the ends themselves taken from within it.
struct Tops {
  double from, to;
};

void append_block(const std::array<Vec3d, 4>& corners, double bottom, const Tops& tops,
                  TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const bool is_top : {false, true}) {
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_at_end = k == 1 || k == 2;
      const double top = std::max(is_at_end ? tops.to : tops.from, bottom);
      mesh.vertices.push_back({corners[k].x, corners[k].y, is_top ? top : bottom});
    }
  }
  for (const Triangle& t : block_triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void append_column(const CheckDam& dam, const Surface& surface, const Block& block,
                   double embedment, TriangleMesh& mesh) {
  const std::array<Vec3d, 4> corners = block.corners(dam);
  const std::optional<double> ground = lowest_ground(corners, surface);
  if (!ground) return;
  const double foot = *ground - embedment;
  const double hair = 1e-6 * (block.to - block.from);
  const Tops crest{dam.top(block.from + hair), dam.top(block.to - hair)};
  const double station = (block.from + block.to) / 2, offset = (block.right + block.left) / 2;
  for (const DamPart& part : solid_parts(dam, station, offset, foot)) {
    const bool has_crest = part.top == dam.top(station);
    append_block(corners, part.bottom, has_crest ? crest : Tops{part.top, part.top}, mesh);
  }
}

/// Long enough pieces for a straight crest, short ones for one that follows the ground.
double pieces(const CheckDam& dam, double length_of_part) {
  const double whole = length(dam.axis);
  const double longest = dam.profile.empty()
                             ? std::max(4 * dam.thickness, whole / most_pieces)
                             : whole / std::min<double>(dam.profile.size(), most_pieces);
  return std::max(1.0, std::ceil(length_of_part / longest - 1e-9));
}

}  // namespace

TriangleMesh dam_mesh(const CheckDam& dam, const Surface& surface, double embedment) {
  TriangleMesh mesh;
  const std::vector<double> stations = dam_stations(dam);
  for (std::size_t k = 1; k < stations.size(); ++k) {
    const double from = stations[k - 1], whole = stations[k] - from;
    const std::vector<double> offsets = dam_offsets(dam, from + whole / 2);
    const double count = pieces(dam, whole);
    for (int i = 0; i < count; ++i) {
      const double start = from + whole * i / count, end = from + whole * (i + 1) / count;
      for (std::size_t j = 1; j < offsets.size(); ++j)
        append_column(dam, surface, {start, end, offsets[j - 1], offsets[j]}, embedment, mesh);
    }
  }
  return mesh;
}

}  // namespace sabo
