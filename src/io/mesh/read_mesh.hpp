#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// Most triangles of a file.
inline constexpr std::size_t max_mesh_triangles = 20'000'000;

/// The mesh of a file whose name ends in .stl (ASCII or binary) or .obj, in the coordinates of the
/// file; corners of neighbouring triangles are not joined. Throws CaseError at `key` with the line
/// or triangle: unreadable, cut off, a number that is none or not finite, a face without its
/// vertices, no triangles, or too many.
TriangleMesh read_mesh(const std::filesystem::path& file, const std::string& key);

/// The same from the bytes of a file; `name` stands in messages.
TriangleMesh parse_stl(std::string_view bytes, const std::string& name, const std::string& key);
TriangleMesh parse_obj(std::string_view text, const std::string& name, const std::string& key);

}  // namespace sabo
