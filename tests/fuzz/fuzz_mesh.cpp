#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "geometry/mesh_topology.hpp"

#include "base/error.hpp"
#include "io/mesh/read_mesh.hpp"

namespace {

/// A mesh that was read can be worked with, whatever it looks like.
void check(const sabo::TriangleMesh& mesh) {
  for (const sabo::Vec3d& v : mesh.vertices)
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) __builtin_trap();
  for (const sabo::Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : t)
      if (corner >= mesh.vertices.size()) __builtin_trap();
  for (const sabo::Vec3d& v : mesh.vertices)
    if (!(std::abs(v.x) < 1e9 && std::abs(v.y) < 1e9 && std::abs(v.z) < 1e9)) return;
  sabo::TriangleMesh joined = sabo::welded(mesh, 1e-3);
  if (!joined.triangles.empty()) sabo::orient_outwards(joined);
}

}  // namespace

/// Whatever the bytes: the readers of meshes return or throw CaseError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    check(sabo::parse_stl(bytes, "a.stl", "key"));
  } catch (const sabo::CaseError&) {
  }
  try {
    check(sabo::parse_obj(bytes, "a.obj", "key"));
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
