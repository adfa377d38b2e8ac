#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec3.hpp"

namespace sabo {

/// One quantity of the particles of a frame.
struct ParticleArray {
  std::string name;           ///< with its unit, e.g. "velocity [m/s]"
  int components = 1;         ///< the values of a particle stand together
  std::vector<float> values;  ///< whole numbers too, which are exact up to 2^24
};

/// Particles at one time, as write_particles_vtp wrote them.
struct ParticleFrame {
  double time = 0;    ///< s
  Vec3d origin = {};  ///< m; CRS coordinates = point + origin
  std::vector<Vec3f> points;
  std::vector<ParticleArray> arrays;

  /// The array of that name; null if the frame has none.
  const ParticleArray* find(std::string_view name) const;
};

/// Reads a file of write_particles_vtp. Throws CaseError when it cannot be read, is damaged or
/// comes from another program. Memory follows the size of the file, whatever it says of itself.
ParticleFrame read_particles_vtp(const std::filesystem::path& file);

/// The same for the bytes of such a file; `place` is its name for the messages.
ParticleFrame parse_particles_vtp(std::string_view bytes, const std::string& place);

/// A frame of a list.
struct PvdEntry {
  double time = 0;   ///< s
  std::string file;  ///< relative to the folder of the list and never outside it
};

/// Reads a list of PvdWriter, in its order. Throws CaseError as read_particles_vtp does, also for a
/// frame outside the folder of the list.
std::vector<PvdEntry> read_pvd(const std::filesystem::path& file);

/// The same for the text of such a list.
std::vector<PvdEntry> parse_pvd(std::string_view text, const std::string& place);

}  // namespace sabo
