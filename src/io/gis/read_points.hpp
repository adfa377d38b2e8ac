#pragma once

#include <filesystem>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// Reads a text file of points, one `x y z` (m) per line between spaces, tabs or commas; `#` starts
/// a comment, a first line of words is a header. `offset` is added. Throws CaseError at
/// release.points with the number of the line: unreadable, empty, not three finite numbers, more
/// than 100 million points.
std::vector<Vec3d> read_points(const std::filesystem::path& file, const Vec3d& offset);

}  // namespace sabo
