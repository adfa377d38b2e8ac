#pragma once

#include <cstddef>

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// The same surface with one vertex where several lie within `tolerance` (m) of each other, and
/// without triangles of which two corners thereby fall together.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

/// What keeps a mesh from having an inside.
struct MeshGaps {
  std::size_t open_edges = 0;  ///< that an odd number of triangles share
  Vec3d open_edge;             ///< the middle of one
  bool is_one_sided = false;   ///< as a Moebius strip: its triangles cannot all face the same way
  bool is_watertight() const { return open_edges == 0 && !is_one_sided; }
};

/// Turns the triangles so that they face outwards, however they were given: within each connected
/// part they face one way, and a part that lies within others is a cavity of them, or within a
/// cavity a solid again. The mesh stays as it is when it is not watertight.
MeshGaps orient_outwards(TriangleMesh& mesh);

}  // namespace sabo
