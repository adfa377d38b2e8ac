#include "geometry/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geometry/solid_angle.hpp"

namespace sabo {
namespace {

constexpr std::size_t most_probes = 32;  // vertices of a part that tell whether it lies in another

/// A side of a triangle.
struct Side {
  std::uint32_t low, high;  // its vertices
  std::uint32_t triangle;
  bool is_upward;  // the triangle goes from low to high
};

/// Sides sorted by edge.
std::vector<Side> sides_of(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

/// A triangle beyond a side; whether it is given to face the other way.
struct Link {
  std::uint32_t triangle;
  bool is_turned;
};
using Links = std::vector<std::vector<Link>>;  // of each triangle

/// Links across edges of two triangles; counts edges of an odd number.
Links links_of(const TriangleMesh& mesh, MeshGaps& gaps) {
  const std::vector<Side> sides = sides_of(mesh);
  Links links(mesh.triangles.size());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low &&
           sides[last].high == sides[first].high)
      ++last;
    const Side &a = sides[first], &b = sides[last - 1];
    if ((last - first) % 2 == 1) {
      if (gaps.open_edges++ == 0)
        gaps.open_edge = 0.5 * (mesh.vertices[a.low] + mesh.vertices[a.high]);
    } else if (last - first == 2) {
      const bool is_turned = a.is_upward == b.is_upward;
      links[a.triangle].push_back({b.triangle, is_turned});
      links[b.triangle].push_back({a.triangle, is_turned});
    }
  }
  return links;
}

enum class Facing { unknown, given, turned };

/// The triangles connected to one, each turned to face as that one does.
std::vector<std::uint32_t> connected_to(std::uint32_t start, const Links& links,
                                        std::vector<Facing>& facing, MeshGaps& gaps) {
  std::vector<std::uint32_t> found{start};
  facing[start] = Facing::given;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::uint32_t here = found[k];
    for (const Link& link : links[here]) {
      const bool is_given = (facing[here] == Facing::given) != link.is_turned;
      const Facing wanted = is_given ? Facing::given : Facing::turned;
      if (facing[link.triangle] == Facing::unknown) {
        facing[link.triangle] = wanted;
        found.push_back(link.triangle);
      }
      if (facing[link.triangle] != wanted) gaps.is_one_sided = true;
    }
  }
  return found;
}

/// A connected part of a mesh, facing outwards.
struct Part {
  TriangleMesh mesh;
  Bounds bounds;
};

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

Part part_of(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles,
             const std::vector<Facing>& facing) {
  Part part;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (const std::uint32_t t : triangles) {
    Triangle own{};
    for (int k = 0; k < 3; ++k) {
      const auto [entry, is_new] =
          number.emplace(mesh.triangles[t][k], static_cast<std::uint32_t>(number.size()));
      if (is_new) part.mesh.vertices.push_back(mesh.corner(t, k));
      own[k] = entry->second;
    }
    if (facing[t] == Facing::turned) turn(own);
    part.mesh.triangles.push_back(own);
  }
  if (volume(part.mesh) < 0)
    for (Triangle& triangle : part.mesh.triangles) turn(triangle);
  part.bounds = bounds_of(part.mesh);
  return part;
}

std::vector<Part> parts_of(const TriangleMesh& mesh, const Links& links, MeshGaps& gaps) {
  std::vector<Facing> facing(mesh.triangles.size(), Facing::unknown);
  std::vector<Part> parts;
  for (std::uint32_t start = 0; start < mesh.triangles.size(); ++start) {
    if (facing[start] != Facing::unknown) continue;
    parts.push_back(part_of(mesh, connected_to(start, links, facing, gaps), facing));
  }
  return parts;
}

bool lies_in(const Part& inner, const Part& outer) {
  if (!outer.bounds.contains(inner.bounds.low) || !outer.bounds.contains(inner.bounds.high))
    return false;
  const std::vector<Vec3d>& vertices = inner.mesh.vertices;
  const std::size_t step = vertices.size() / most_probes + 1;
  for (std::size_t k = 0; k < vertices.size(); k += step)
    if (!(winding_number(outer.mesh, vertices[k]) > 0.5)) return false;
  return true;
}

/// Vertices that are taken for one, found by cubes of twice the tolerance.
class VertexMerger {
 public:
  explicit VertexMerger(double tolerance) : tolerance_(tolerance) {}

  std::uint32_t number_of(const Vec3d& v, std::vector<Vec3d>& vertices) {
    const double side = 2 * tolerance_;
    const auto first = [&](double x) { return std::floor((x - tolerance_) / side); };
    const auto last = [&](double x) { return std::floor((x + tolerance_) / side); };
    for (double i = first(v.x); i <= last(v.x); ++i)
      for (double j = first(v.y); j <= last(v.y); ++j)
        for (double k = first(v.z); k <= last(v.z); ++k) {
          const auto found = cubes_.find(key_of(i, j, k));
          if (found == cubes_.end()) continue;
          for (const std::uint32_t n : found->second)
            if (norm(vertices[n] - v) <= tolerance_) return n;
        }
    const auto number = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(v);
    cubes_[key_of(std::floor(v.x / side), std::floor(v.y / side), std::floor(v.z / side))]
        .push_back(number);
    return number;
  }

 private:
  /// Cubes that share a key by chance only cost a comparison.
  static std::uint64_t key_of(double i, double j, double k) {
    std::uint64_t key = 0;
    for (const double n : {i, j, k})
      key = key * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(std::llround(n));
    return key;
  }

  double tolerance_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
  TriangleMesh result;
  VertexMerger merger(tolerance);
  std::vector<std::uint32_t> number(mesh.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v)
    number[v] = merger.number_of(mesh.vertices[v], result.vertices);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle own{number[a], number[b], number[c]};
    if (own[0] == own[1] || own[1] == own[2] || own[2] == own[0]) continue;
    result.triangles.push_back(own);
  }
  return result;
}

MeshGaps orient_outwards(TriangleMesh& mesh) {
  MeshGaps gaps;
  const Links links = links_of(mesh, gaps);
  if (!gaps.is_watertight()) return gaps;
  const std::vector<Part> parts = parts_of(mesh, links, gaps);
  if (!gaps.is_watertight()) return gaps;
  TriangleMesh result;
  for (const Part& part : parts) {
    const auto around = std::count_if(parts.begin(), parts.end(), [&](const Part& other) {
      return &other != &part && lies_in(part, other);
    });
    TriangleMesh own = part.mesh;
    if (around % 2 == 1)
      for (Triangle& triangle : own.triangles) turn(triangle);
    append(result, own);
  }
  mesh = std::move(result);
  return gaps;
}

}  // namespace sabo
