#include "analysis/curtain.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/host_loops.hpp"
#include "math/turn.hpp"

namespace sabo {
namespace {

struct CrossingList {
  std::vector<Crossing> crossings;
  void join(const CrossingList& next) {
    crossings.insert(crossings.end(), next.crossings.begin(), next.crossings.end());
  }
};

/// Sign of a + b e + c e^2 for vanishing e > 0; the value zero counts as negative.
bool is_positive(double a, double b, double c) {
  if (a != 0) return a > 0;
  if (b != 0) return b > 0;
  return c > 0;
}

/// Whether point + (e, e^2) is to the left of a -> b.
bool point_is_left(const Vec3d& a, const Vec3d& b, const Vec3d& point) {
  return is_positive(turn(a, b, point), a.y - b.y, b.x - a.x);
}

/// Whether a vertex is to the left of the path from -> to, shifted by (e, e^2).
bool vertex_is_left(const Vec3d& from, const Vec3d& to, const Vec3d& vertex) {
  return is_positive(turn(from, to, vertex), to.y - from.y, from.x - to.x);
}

}  // namespace

Curtain::Curtain(Polyline line)
    : line_(std::move(line)),
      west_(std::numeric_limits<double>::infinity()),
      east_(-west_),
      south_(west_),
      north_(-west_) {
  for (const Vec3d& vertex : line_.vertices) {
    west_ = std::min(west_, vertex.x);
    east_ = std::max(east_, vertex.x);
    south_ = std::min(south_, vertex.y);
    north_ = std::max(north_, vertex.y);
  }
}

int Curtain::count(const Vec3d& from, const Vec3d& to) const {
  int net = 0;
  for (std::size_t k = 1; k < line_.vertices.size(); ++k) {
    const Vec3d& a = line_.vertices[k - 1];
    const Vec3d& b = line_.vertices[k];
    const bool starts_left = point_is_left(a, b, from);
    if (starts_left == point_is_left(a, b, to)) continue;
    if (vertex_is_left(from, to, a) == vertex_is_left(from, to, b)) continue;
    net += starts_left ? 1 : -1;
  }
  return net;
}

std::vector<Crossing> Curtain::crossings(std::span<const Vec3d> from, std::span<const Vec3d> to,
                                         int threads) const {
  return blocked_sum<CrossingList>(
             from.size(), host_threads(threads),
             [&](std::size_t i, CrossingList& list) {
               if (const int net = crossings(from[i], to[i]); net != 0)
                 list.crossings.push_back({static_cast<std::uint32_t>(i), net});
             })
      .crossings;
}

}  // namespace sabo
