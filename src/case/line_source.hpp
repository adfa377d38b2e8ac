#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace sabo {

/// Vector file or coordinates; exactly one is set when the key was given.
/// File paths of a case are absolute once it has been read.
struct LineSource {
  std::filesystem::path file;
  std::vector<std::array<double, 3>> coordinates;
  bool has_z = false;  ///< of `coordinates`
  bool given() const { return !file.empty() || !coordinates.empty(); }
};

}  // namespace sabo
