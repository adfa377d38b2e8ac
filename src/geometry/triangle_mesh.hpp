#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// Corners of three vertices each, anticlockwise seen from outside once the mesh is oriented.
using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles; every corner is a vertex of the list.
struct TriangleMesh {
  std::vector<Vec3d> vertices;
  std::vector<Triangle> triangles;

  const Vec3d& corner(std::size_t triangle, int k) const {
    return vertices[triangles[triangle][k]];
  }
};

/// The smallest box along the axes that holds something.
struct Bounds {
  Vec3d low;
  Vec3d high;

  bool contains(const Vec3d& p) const {
    return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y &&
           p.z <= high.z;
  }
  Bounds widened(double by) const { return {low - Vec3d{by, by, by}, high + Vec3d{by, by, by}}; }
  Vec3d size() const { return high - low; }
};

/// Of the vertices; the mesh has some.
Bounds bounds_of(const TriangleMesh& mesh);

/// Half the cross product of two sides: along the normal, as long as the triangle is large, m2.
Vec3d area_vector(const TriangleMesh& mesh, std::size_t triangle);

/// Area of all triangles, m2.
double area(const TriangleMesh& mesh);

/// Volume within a closed mesh by the divergence theorem, m3; negative when it is inside out.
double volume(const TriangleMesh& mesh);

/// Appends the triangles of another mesh.
void append(TriangleMesh& mesh, const TriangleMesh& more);

}  // namespace sabo
