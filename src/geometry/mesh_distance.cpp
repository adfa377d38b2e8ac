#include "geometry/mesh_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/nearest_on_triangle.hpp"
#include "geometry/solid_angle.hpp"

namespace sabo {
namespace {

constexpr std::uint32_t most_in_leaf = 4;  // triangles
constexpr double far = 2;                  // radii from which a dipole stands for triangles
constexpr int deepest = 64;                // of the tree, which halves: more than 32 bits need

double distance_to(const Bounds& box, const Vec3d& p) {
  const Vec3d outside{std::max({box.low.x - p.x, p.x - box.high.x, 0.0}),
                      std::max({box.low.y - p.y, p.y - box.high.y, 0.0}),
                      std::max({box.low.z - p.z, p.z - box.high.z, 0.0})};
  return norm(outside);
}

}  // namespace

MeshDistance::MeshDistance(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  nodes_.reserve(mesh_.triangles.size());
  build(0, static_cast<std::uint32_t>(mesh_.triangles.size()));
}

/// Adds the node of some triangles and those below it.
void MeshDistance::build(std::uint32_t first, std::uint32_t last) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.first = first;
  node.last = last;
  node.bounds = {mesh_.corner(first, 0), mesh_.corner(first, 0)};
  double whole = 0;
  Vec3d middle;
  const auto centre_of = [&](std::size_t t) {
    return 1.0 / 3 * (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2));
  };
  for (std::uint32_t t = first; t < last; ++t) {
    for (int k = 0; k < 3; ++k) {
      const Vec3d& v = mesh_.corner(t, k);
      Bounds& b = node.bounds;
      b.low = {std::min(b.low.x, v.x), std::min(b.low.y, v.y), std::min(b.low.z, v.z)};
      b.high = {std::max(b.high.x, v.x), std::max(b.high.y, v.y), std::max(b.high.z, v.z)};
    }
    const Vec3d area = area_vector(mesh_, t);
    node.area += area;
    whole += norm(area);
    middle += norm(area) * centre_of(t);
  }
  node.centre = whole > 0 ? (1 / whole) * middle : mesh_.corner(first, 0);
  for (std::uint32_t t = first; t < last; ++t)
    for (int k = 0; k < 3; ++k)
      node.radius = std::max(node.radius, norm(mesh_.corner(t, k) - node.centre));
  nodes_.push_back(node);
  if (last - first <= most_in_leaf) return;

  const Vec3d size = node.bounds.size();
  const auto along = [&](const Triangle& t) {
    const Vec3d sum = mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]];
    return size.x >= size.y && size.x >= size.z ? sum.x : size.y >= size.z ? sum.y : sum.z;
  };
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(mesh_.triangles.begin() + first, mesh_.triangles.begin() + half,
                   mesh_.triangles.begin() + last, [&](const Triangle& a, const Triangle& b) {
                     return along(a) != along(b) ? along(a) < along(b) : a < b;
                   });
  build(first, half);
  nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
  build(half, last);
}

template <class Accepts>
void MeshDistance::search(const Vec3d& point, MeshPoint& best, Accepts&& accepts) const {
  std::uint32_t stack[deepest];
  int waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t number = stack[--waiting];
    const Node& node = nodes_[number];
    if (distance_to(node.bounds, point) > best.distance) continue;
    if (node.second == 0) {
      for (std::uint32_t t = node.first; t < node.last; ++t) {
        const Vec3d found =
            nearest_on_triangle(point, mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2));
        const MeshPoint candidate{found, norm(found - point), t};
        if (candidate.distance < best.distance && accepts(candidate)) best = candidate;
      }
      continue;
    }
    // The nearer child first: it leaves less to search in the other.
    std::uint32_t near = number + 1, other = node.second;
    if (distance_to(nodes_[other].bounds, point) < distance_to(nodes_[near].bounds, point))
      std::swap(near, other);
    stack[waiting++] = other;
    stack[waiting++] = near;
  }
}

std::optional<MeshPoint> MeshDistance::nearest(const Vec3d& point, double reach) const {
  MeshPoint best{{}, std::nextafter(reach, HUGE_VAL), 0};
  const double start = best.distance;
  search(point, best, [](const MeshPoint&) { return true; });
  return best.distance < start ? std::optional(best) : std::nullopt;
}

std::optional<MeshPoint> MeshDistance::nearest(
    const Vec3d& point, double reach, const std::function<bool(const MeshPoint&)>& accepts) const {
  MeshPoint best{{}, std::nextafter(reach, HUGE_VAL), 0};
  const double start = best.distance;
  search(point, best, accepts);
  return best.distance < start ? std::optional(best) : std::nullopt;
}

bool MeshDistance::is_inside(const Vec3d& point) const {
  return bounds().contains(point) && winding_of(0, point) > 0.5;
}

double MeshDistance::winding_of(std::uint32_t number, const Vec3d& point) const {
  const Node& node = nodes_[number];
  const Vec3d way = node.centre - point;
  const double distance = norm(way);
  if (distance > far * node.radius)
    return dot(node.area, way) / (4 * std::numbers::pi * distance * distance * distance);
  double sum = 0;
  if (node.second == 0) {
    for (std::uint32_t t = node.first; t < node.last; ++t)
      sum += solid_angle_share(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), point);
    return sum;
  }
  return winding_of(number + 1, point) + winding_of(node.second, point);
}

}  // namespace sabo
